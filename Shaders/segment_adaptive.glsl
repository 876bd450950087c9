// Emission and absorption along one ray segment in which the scalar is linear, to a tolerance.
//
// A piece is evaluated with its exact means of C tau and tau, as if colour and extinction were spread
// evenly in it: the optical depth is exact, only the order of the colours in the piece is lost. The error of
// a piece of optical depth D is at most sigma g(D) by the Cauchy-Schwarz inequality, where sigma is the
// standard deviation of the colour, weighted by extinction, and
//   g(D)^2 = D (1 - exp(-2D)) / 2 - (1 - exp(-D))^2.
// Pieces are halved or so until their error, seen through what lies in front, is below the tolerance.

// g(D); D^2 / sqrt(12) for thin pieces, where the closed form cancels. transmitted: exp(-D).
real orderErrorFactor(real depth, real transmitted)
{
  real absorbed = real(1) - transmitted;
  real square = real(0.5) * depth * (real(1) - transmitted * transmitted) - absorbed * absorbed;
  return depth < real(0.25) ? depth * depth * real(0.28867513459)
                            : min(sqrt(max(square, real(0))), real(1));
}

// From table position begin to end over a length in scalar opacity unit distances. `at` is the table at the
// last end, which is mostly this begin; where it isn't, the first trial only reads the table there. Returns
// the number of trials. The body stands at the end of one loop that mostly runs once: an `if` costs a
// software renderer as much as both its branches.
int integrateSegment(
  real begin, real end, real opticalLength, INOUT(TablePoint) at, INOUT(Radiance) radiance)
{
  bool loaded = at.x == begin;
  real position = real(0); // how far it is integrated, 0..1
  real step = real(1);     // the piece to try
  int trials = 0;
  bool pending = true;
  do
  {
    bool whole = !(position + step < real(1)); // also if it is NaN: the loop ends whatever the input
    real share = whole ? real(1) - position : step;
    real target = whole ? end : begin + (end - begin) * (position + step);
    TablePoint next = tablePoint(loaded ? target : begin);
    vec4 mean = meanBetween(at, next);
    real pieceLength = loaded ? share * opticalLength : real(0);
    real depth = mean.w * pieceLength;
    real transmitted = exp(-depth);

    // A deviation of colours is at most sqrt(3) / 2, and g(D) at most D^2 / sqrt(12): no need to look closer.
    bool accepted = radiance.transmittance * depth * depth * real(0.25) <= integrationTolerance ||
      trials >= mostTrials;
    real shrink = real(1);
    if (!accepted)
    {
      real perTau = real(1) / mean.w;
      vec3 color = vec3(mean.x, mean.y, mean.z) * perTau;
      real variance = squareMeanBetween(at, next) * perTau - dot(color, color);
      real error = radiance.transmittance *
        min(sqrt(max(variance, real(0))) * orderErrorFactor(depth, transmitted), real(1));
      accepted = error <= integrationTolerance;
      // The error grows with the third power of the step; the root 3/8 is a little more careful than 1/3.
      real root = sqrt(sqrt(integrationTolerance / max(error, integrationTolerance)));
      shrink = clamp(real(0.9) * root * sqrt(root), real(0.1), real(0.5));
    }
    if (accepted)
    {
      absorb(radiance, mean, pieceLength, transmitted);
      pending = !(loaded && whole) && radiance.transmittance >= leastTransmittance;
      position = loaded ? position + share : position;
      step = loaded ? real(2) * step : step;
      at = next;
      loaded = true;
    }
    else
    {
      step = share * shrink;
    }
    trials = trials + 1;
  } while (pending);
  return trials;
}
