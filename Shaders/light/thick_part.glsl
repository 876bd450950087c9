// The light of a part of a cell that absorbs much of it: sampled at both ends and, if these differ, in the middle.

CONSTANT real THICK_PART = real(0.03125);        // share of the light of the pixel; thinner ones wait for samples
CONSTANT real PART_OF_DENSE = real(0.001953125); // in place of THICK_PART, after a part of the cell was too dense
CONSTANT real MOST_OF_A_PART = real(0.25); // share of the ray's light
CONSTANT real LEAST_THICK_PART = real(0.00048828125); // of the interval

// Whether a part that goes from `before` to `tried` keeps the tolerance. Then what waits in it is lit, and so is what
// waited before.
bool lightThickPart(
  Ray ray, vec2 depths, bool last, Radiance before, INOUT(Radiance) tried, INOUT(SamplePause) pause)
{
  Radiance own = pendingSince(before, tried);
  vec4 begin = pause.light;
  vec4 end = pause.light;
  vec4 mean = pause.light;
  bool within = false;
  int k = pause.lightFresh ? 1 : 0;
  while (k < 3 && pause.samples < mostLightSamples)
  {
    pause.samples = pause.samples + 1;
    real place = k == 0 ? real(0) : (k == 1 ? real(1) : seenFraction(before.transmittance, tried.transmittance));
    vec4 found = sampleLight(ray, pause.start, depths.x + (depths.y - depths.x) * place);
    begin = k == 0 ? found : begin;
    end = k == 1 ? found : end;
    vec4 between = (begin + end) * real(0.5);
    mean = k == 2 ? (between + found) * real(0.5) : between;
    // By both ends, else by the middle.
    real change = pendingTimes(k == 2 ? found - between : (end - begin) * real(0.5), own);
    within = k > 0 && (change <= real(0.25) * lightTolerance || isFrugal(pause));
    k = within ? 3 : k + 1;
  }
  last = last || pause.samples >= mostLightSamples;
  if (within || last)
  {
    vec3 color = before.color;
    addPending(before, pause.lightKnown ? (pause.light + begin) * real(0.5) : begin);
    addPending(own, mean);
    tried = own;
    tried.color = tried.color + (before.color - color);
    pause.light = end;
    pause.lightKnown = true;
    pause.lightFresh = true;
  }
  return within || last;
}
