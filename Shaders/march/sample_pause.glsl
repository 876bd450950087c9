// A march that samples shadows along its ray pauses after a cell when enough opacity has been gathered since the last
// sample (light/sampled_shadows.glsl).

struct SamplePause
{
  bool due;           // the march pauses; the next marchToExit() continues from there,
  bool ended;         // unless the ray had left the mesh or was finished
  real nextSample;    // the transmittance at which the next sample is due
  real transmittance; // before the last cell
  LightStart start;   // in the last crossed cell, without its point
  real seenDepth;     // the mean depth of its visible light
};

SamplePause noPause()
{
  SamplePause pause;
  pause.due = false;
  pause.ended = false;
  pause.nextSample = real(-1); // never
  return pause;
}

// The mean position, 0..1, of the visible light of a homogeneous interval, given the transmittance before and behind
// it: with its optical depth D it is 1 / D - 1 / (exp(D) - 1), a half in a thin one.
real seenFraction(real before, real behind)
{
  real absorbed = (before - behind) / max(before, TINY);
  real depth = -log(max(real(1) - absorbed, TINY));
  real thin = real(0.5) - depth * (real(1) / real(12));
  return depth < real(0.05) ? thin : real(1) / depth - (real(1) - absorbed) / max(absorbed, TINY);
}
