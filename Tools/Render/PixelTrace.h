// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What --pixel prints and --pixel-json writes: the ray of one pixel, cell by cell.
 */
#ifndef tetmarch_PixelTrace_h
#define tetmarch_PixelTrace_h

#include "CommandLine.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <array>
#include <string>

class vtkTetMarchFrameStatistics;

namespace tetmarch
{

struct PixelTrace
{
  bool Structured = false;       // cells are those of an image, or leaves; else tetrahedra
  std::array<double, 4> Drawn{}; // by the GPU: premultiplied red, green, blue, opacity
  vtkNew<vtkTable> Float;        // by TraceRay() of the mapper
  vtkNew<vtkTable> Double;
  vtkNew<vtkTable> GroundTruth;
};

/// A value of a column of TraceRay().
double GetCellValue(vtkTable* cells, const char* column, vtkIdType row, int component = 0);
/// What TraceRay() says of all of the ray.
double GetRayValue(vtkTable* cells, const char* name, int component = 0);
std::array<double, 4> GetRayColor(vtkTable* cells);

/// The first row in which two rays pass different cells or tetrahedra, or -1 if there is none.
vtkIdType FindParting(vtkTable* a, vtkTable* b);

std::string FormatPixelText(const CommandLine& commandLine, const std::string& arrayName,
  vtkTetMarchFrameStatistics* statistics, const PixelTrace& trace);

std::string FormatPixelJson(const CommandLine& commandLine, const std::string& arrayName,
  vtkTetMarchFrameStatistics* statistics, const PixelTrace& trace);

} // namespace tetmarch

#endif
