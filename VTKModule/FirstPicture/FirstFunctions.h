// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions with a transparent background and emphasis on values far from it.
// Opacity: nearly 0 up to a 20th of the distance from the background to the farther end of the
// range, from there to that end it rises with a power of the distance, on both sides if the range
// has both. Colour: if the background lies in the middle half of the range, Moreland's diverging
// map, cool to warm, with its neutral colour at the background (K. Moreland, Diverging Color Maps
// for Scientific Visualization, 2009); else the perceptually uniform sequential map plasma (N.
// Smith and S. van der Walt, 2015).
#ifndef TetMarchFirstPictureFirstFunctions_h
#define TetMarchFirstPictureFirstFunctions_h

#include "FirstPicture/ValueStatistics.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace tetmarch
{

void makeFirstColors(const ValueStatistics& statistics, vtkColorTransferFunction* colors);

struct OpacityShape
{
  double Exponent = 2; // of the power
  double Least = 0;    // the opacity of the background, 0 to 1
  double Most = 1;     // at the end of the range that is farther from the background, 0 to 1
};

void makeFirstOpacity(
  const ValueStatistics& statistics, const OpacityShape& shape, vtkPiecewiseFunction* opacity);

} // namespace tetmarch

#endif
