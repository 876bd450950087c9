// Emission and absorption along one ray segment in which the scalar is linear, to a tolerance.
//
// A piece is evaluated with its exact means of C tau and tau, as if colour and extinction were spread
// evenly in it: the optical depth is exact, only the order of the colours in the piece is lost. The error of
// a piece of optical depth D is at most sigma g(D) by the Cauchy-Schwarz inequality, where sigma is the
// standard deviation of the colour, weighted by extinction, and
//   g(D)^2 = D (1 - exp(-2D)) / 2 - (1 - exp(-D))^2.
// Pieces are halved or so until their error, seen through what lies in front, is below the tolerance.

// The factor g(D) of the error bound; D^2 / sqrt(12) for thin pieces, where the closed form cancels.
real orderErrorFactor(real depth)
{
  real absorbed = real(1) - exp(-depth);
  real square = real(0.5) * depth * (real(1) - exp(real(-2) * depth)) - absorbed * absorbed;
  return depth < real(0.25) ? depth * depth * real(0.28867513459)
                            : min(sqrt(max(square, real(0))), real(1));
}

// A segment on its way to being integrated, piece by piece.
struct Segment
{
  real begin;         // table positions of its ends
  real end;
  real opticalLength; // length in units of the scalar opacity unit distance
  real position;      // how far it is integrated, 0..1
  real step;          // the piece to try next, as a share of the whole
  int trials;
};

CONSTANT int MOST_TRIALS = 64;

Segment beginSegment(real begin, real end, real opticalLength)
{
  Segment segment;
  segment.begin = begin;
  segment.end = end;
  segment.opticalLength = opticalLength;
  segment.position = real(0);
  segment.step = real(1);
  segment.trials = 0;
  return segment;
}

bool isDone(Segment segment) { return segment.position >= real(1); }

// One evaluation: read the table at the end of the next piece, and take the piece or shorten it. `at` is the
// table at the segment's position; where it isn't yet (a new start), the evaluation only reads it.
void integratePiece(INOUT(Segment) segment, INOUT(TablePoint) at, INOUT(Radiance) radiance)
{
  bool loaded = segment.trials > 0 || at.x == segment.begin;
  bool whole = segment.position + segment.step >= real(1);
  real target = segment.begin + (segment.end - segment.begin) * (segment.position + segment.step);
  TablePoint next = tablePoint(loaded ? (whole ? segment.end : target) : segment.begin);

  vec4 mean = meanBetween(at, next);
  real share = whole ? real(1) - segment.position : segment.step;
  real opticalLength = loaded ? share * segment.opticalLength : real(0);
  real depth = mean.w * opticalLength;

  // A deviation of colours is at most 1/2, and g(D) below D^2 / sqrt(12).
  bool accepted = radiance.transmittance * depth * depth * real(0.25) <= integrationTolerance ||
    segment.trials >= MOST_TRIALS;
  real shrink = real(1);
  if (!accepted)
  {
    vec3 color = vec3(mean.x, mean.y, mean.z) * (real(1) / mean.w);
    real variance = squareMeanBetween(at, next) / mean.w - dot(color, color);
    real error =
      radiance.transmittance * min(sqrt(max(variance, real(0))) * orderErrorFactor(depth), real(1));
    accepted = error <= integrationTolerance;
    shrink = clamp(real(0.9) * pow(integrationTolerance / max(error, integrationTolerance), real(1) / real(3)),
      real(0.1), real(0.5));
  }
  if (accepted)
  {
    absorb(radiance, mean, opticalLength);
    segment.position = loaded ? (whole ? real(1) : segment.position + segment.step) : segment.position;
    segment.step = loaded ? real(2) * segment.step : segment.step;
    at = next;
  }
  else
  {
    segment.step = share * shrink;
  }
  segment.trials = segment.trials + 1;
}
