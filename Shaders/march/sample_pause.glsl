// A march that samples shadows along its ray pauses behind a cell whenever enough of the volume has been seen
// since the last sample (light/sampled_shadows.glsl).

struct SamplePause
{
  bool due;           // the march pauses; the next marchToExit() goes on from there,
  bool ended;         // unless the ray had left the mesh or was finished
  real nextSample;    // the transmittance at which the next sample is due
  real transmittance; // before the last cell
  LightStart start;   // in the cell that was crossed last, but for its point
  real seenDepth;     // the average depth of what is seen of it
};

SamplePause noPause()
{
  SamplePause pause;
  pause.due = false;
  pause.ended = false;
  pause.nextSample = real(-1); // never
  return pause;
}

// How far into a homogeneous interval the average of what is seen of it lies, by the transmittance before and behind it:
// with its optical depth D it is 1 / D - 1 / (exp(D) - 1), a half in a thin one.
real seenFraction(real before, real behind)
{
  real absorbed = (before - behind) / max(before, TINY);
  real depth = -log(max(real(1) - absorbed, TINY));
  real thin = real(0.5) - depth * (real(1) / real(12));
  return depth < real(0.05) ? thin : real(1) / depth - (real(1) - absorbed) / max(absorbed, TINY);
}
