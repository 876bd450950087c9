// A march that samples shadows along its ray pauses when enough opacity has been gathered since the last sample: after a
// cell (light/sampled_shadows_even.glsl), or within one (light/sampled_shadows_adaptive.glsl).

struct SamplePause
{
  bool due;           // the march pauses; the next marchToExit() continues from there,
  bool ended;         // unless the ray had left the mesh or was finished
  real nextSample;    // the transmittance at which the next sample is due
#if TETMARCH_PAUSES_WITHIN
  real least;         // the transmittance that a part of a cell should keep
  bool within;        // the ray pauses within the last crossed cell
  int cells;          // crossed by the last step
  LightStart start;   // in the last visible cell, without its point
  real depth;         // up to which that is gathered
#else
  real transmittance; // before the last cell
  LightStart start;   // in the last crossed cell, without its point
  real seenDepth;     // the mean depth of its visible light
#endif
};

SamplePause noPause()
{
  SamplePause pause;
  pause.due = false;
  pause.ended = false;
  pause.nextSample = real(-1); // never
#if TETMARCH_PAUSES_WITHIN
  pause.least = real(-1);
  pause.within = false;
  pause.cells = 0;
  pause.depth = real(0);
#endif
  return pause;
}
