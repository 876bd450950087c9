// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// From what the diagnostic march counted to the statistics that users ask for.
#ifndef TetMarchGLFrameFigures_h
#define TetMarchGLFrameFigures_h

class vtkFloatArray;
class vtkTetMarchFrameStatistics;

namespace tetmarch
{

class Diagnostics;

/** Error bounds, cells and lookups. */
void takeMeasures(const Diagnostics& counted, vtkTetMarchFrameStatistics* statistics);

/** True errors, from the frame in double precision: premultiplied RGBA, rows from the bottom. */
void takeTrueErrors(
  const Diagnostics& counted, vtkFloatArray* reference, vtkTetMarchFrameStatistics* statistics);

} // namespace tetmarch

#endif
