// The interval of a cell in parts in which light changes evenly: adaptive quadrature (Gander and Gautschi, "Adaptive
// quadrature - revisited", 2000). The light in the middle of a part is compared with the mean of its ends, and corrects
// it, as in Simpson's rule. If the estimated error exceeds the budget of the pixel's light, half of the part is tried.

CONSTANT real LEAST_PART = real(0.0625); // of the interval
CONSTANT real LONG_PART = real(0.25);    // it may hide a highlight,
CONSTANT real THIN_PART = real(0.015625); // unless it absorbs less than this
CONSTANT int MOST_LIT_TRIALS = 200;      // the last one takes the rest

// A quarter of a pixel's tolerance is available from the begin, half of it in proportion to the ray's absorption.
real shadeBudget(Radiance radiance, real absorbed)
{
  real earned = real(0.25) + real(0.5) * (real(1) - radiance.transmittance + absorbed);
  return max(real(0.25) * (lightTolerance * earned - radiance.shadeError), real(0.5) * lightTolerance * absorbed);
}

// As gatherCell().
#if TETMARCH_PAUSES_WITHIN
int gatherLitParts(Ray ray, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance,
  INOUT(SamplePause) pause)
#else
int gatherLitParts(Ray ray, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
#endif
{
  CellInterval whole = cell;
  real extent = whole.end - whole.begin;
  Shade from = whole.enterShade;
  Shade last = whole.leaveShade;
  if (whole.begin > whole.enter.x)
  {
    from = shadeAtFace(ray, pointWithin(ray, whole, whole.begin));
  }
  if (whole.end < whole.leave.x)
  {
    last = shiftShade(
      whole.enterShade, whole.enterShade, last, fractionAt(whole.enter, whole.leave, whole.end));
  }
  Shade to = last;
  real position = real(0); // of the part in the interval
  real step = real(1);     // its length
  bool inMiddle = true;    // else the shade at its end is missing
  int lookups = 0;
  int trials = 0;
  bool pending = true;
  while (pending && trials < MOST_LIT_TRIALS)
  {
    trials = trials + 1;
    bool rest = trials == MOST_LIT_TRIALS;
    step = rest ? real(1) - position : step;
    if (rest)
    {
      to = last;
    }
    inMiddle = inMiddle || rest;
    real end = position + step;
    real depth = whole.begin + extent * (inMiddle ? position + real(0.5) * step : end);
    Shade found = shadeAtFace(ray, pointWithin(ray, whole, depth));
    if (inMiddle)
    {
      Shade mean = shiftShade(from, from, to, real(0.5));
      real correction = real(2) / real(3);
      cell.begin = position > real(0) ? whole.begin + extent * position : whole.begin;
      cell.end = end < real(1) ? whole.begin + extent * end : whole.end;
      cell.enterShade = shiftShade(from, mean, found, correction);
      cell.leaveShade = shiftShade(to, mean, found, correction);
      Radiance tried = radiance;
      lookups = lookups + gatherCell(thicknessPerDepth, cell, tried);
      real absorbed = radiance.transmittance - tried.transmittance;
      real error = real(0.5) * absorbed * changeOfLight(mean.lit, found.lit);
      real budget = shadeBudget(radiance, absorbed);
      bool isFine = error <= budget && (step <= LONG_PART || absorbed <= THIN_PART);
      bool accepted = isFine || step <= LEAST_PART || rest;
#if TETMARCH_PAUSES_WITHIN
      bool beyond = isBeyondSample(tried.transmittance, step, pause) && !rest;
      accepted = accepted && !beyond;
#endif
      if (accepted)
      {
        radiance = tried;
        radiance.shadeError = radiance.shadeError + error;
        position = end;
        from = to;
        to = last;
        step = min(error <= real(0.125) * budget ? real(2) * step : step, real(1) - position);
        inMiddle = position + step >= real(1);
      }
#if TETMARCH_PAUSES_WITHIN
      else if (beyond && isFine)
      {
        step = step * fractionToSample(radiance.transmittance, tried.transmittance, pause);
        inMiddle = false;
      }
#endif
      else
      {
        to = found;
        step = real(0.5) * step;
      }
      pending = position < real(1) && !isOpaque(radiance);
#if TETMARCH_PAUSES_WITHIN
      pause.within = pending && radiance.transmittance <= pause.nextSample;
      pending = pending && !pause.within;
#endif
    }
    else
    {
      to = found;
      inMiddle = true;
    }
  }
#if TETMARCH_COUNTS_TURNS
  countTurns(trials + 1);
#endif
  cell.begin = whole.begin;
#if TETMARCH_PAUSES_WITHIN
  cell.end = pause.within ? whole.begin + extent * position : whole.end;
#else
  cell.end = whole.end;
#endif
  cell.enterShade = whole.enterShade;
  cell.leaveShade = whole.leaveShade;
  return lookups;
}
