// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray of one pixel of a pipeline's last frame as a table.
#ifndef TetMarchMapperTraceTable_h
#define TetMarchMapperTraceTable_h

#include <string>

class vtkTable;
class vtkVolume;

namespace tetmarch
{

class CellOrigins;
class Pipeline;
struct MapperState;

/** With the numbers of vtkTetMarchVolumeMapper::TraceArithmeticType. */
enum class TraceArithmetic
{
  Float,
  Double,
  GroundTruth
};

struct TracedPixel
{
  vtkVolume* Volume = nullptr; // that was drawn
  int X = 0;                   // counted from the lower left of the window
  int Y = 0;
  int Arithmetic = 0; // a TraceArithmetic
};

/** Marches the ray and fills the table as vtkTetMarchVolumeMapper::TraceRay() says. Returns an
 * empty string, or why no ray is traced. */
std::string traceRay(Pipeline& pipeline, const MapperState& state, const TracedPixel& pixel,
  const CellOrigins& origins, bool hasBlocks, vtkTable* cells);

} // namespace tetmarch

#endif
