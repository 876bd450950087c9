// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the diagnostic march counted becomes the statistics that users ask for.
#ifndef TetMarchMapperFrameMeasures_h
#define TetMarchMapperFrameMeasures_h

class vtkFloatArray;
class vtkTetMarchFrameStatistics;

namespace tetmarch
{

class Diagnostics;

/** Cells, lookups and error bounds of each pixel. */
void takeMeasures(const Diagnostics& counted, vtkTetMarchFrameStatistics* statistics);

/** True errors, from the frame in double precision: premultiplied RGBA, rows from the bottom. */
void takeTrueErrors(
  const Diagnostics& counted, vtkFloatArray* reference, vtkTetMarchFrameStatistics* statistics);

} // namespace tetmarch

#endif
