// A march that samples shadows along its ray pauses after a cell when enough opacity has been gathered since the last
// sample (light/sampled_shadows_even.glsl, _adaptive).

struct SamplePause
{
  bool due;           // the march pauses; the next marchToExit() continues from there,
  bool ended;         // unless the ray had left the mesh or was finished
  real nextSample;    // the transmittance at which the next sample is due
  real transmittance; // before the last cell
  LightStart start;   // in the last crossed cell, without its point
#if TETMARCH_LIGHT_TOLERANCE
  LightStart seenStart; // of the last visible cell
  real seenBegin;       // depths between which it was gathered
  real seenEnd;
  real before;          // the transmittance before it
  vec4 light;           // at the last sample
  bool lightKnown;      // there is one
  int samples;          // their number
  bool lightFresh;      // it is where the march is
#else
  real seenDepth;     // the mean depth of its visible light
#endif
};

SamplePause noPause()
{
  SamplePause pause;
  pause.due = false;
  pause.ended = false;
  pause.nextSample = real(-1); // never
#if TETMARCH_LIGHT_TOLERANCE
  pause.seenBegin = real(0);
  pause.seenEnd = real(0);
  pause.before = real(1);
  pause.light = vec4(real(1), real(1), real(1), real(1));
  pause.lightKnown = false;
  pause.samples = 0;
  pause.lightFresh = false;
#endif
  return pause;
}

#if TETMARCH_LIGHT_TOLERANCE
// After half of the samples, steps are taken however much light changes.
bool isFrugal(SamplePause pause) { return 2 * pause.samples > mostLightSamples; }

// After the last crossed cell was gathered.
void keepSeenCell(CellInterval cell, INOUT(SamplePause) pause)
{
  if (cell.seen)
  {
    pause.seenStart = pause.start;
    pause.seenBegin = cell.begin;
    pause.seenEnd = cell.end;
    pause.before = pause.transmittance;
  }
}
#endif
