// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A hard case drawn through the GL, by our mapper or by one of VTK's
 */
#ifndef tetmarch_testing_HardCaseDrawing_h
#define tetmarch_testing_HardCaseDrawing_h

#include "HardCase.h"

#include "Diagnostics/MarchCounters.h"

#include "Images.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRenderWindow;

namespace tetmarch::testing
{
struct Drawn
{
  Image Picture;                     ///< premultiplied over black; alpha only of ours
  MarchCounters Counters;            ///< only of ours
  std::vector<std::string> Messages; ///< errors and warnings of the mapper, in their order
};

/// tetmarch, projected, bunyk, zsweep.
const std::vector<std::string>& mapperNames();

/// One frame in the window, which is emptied before. Our picture is the float one from before it is
/// blended; the others' is what stands in the framebuffer, in steps of 1/255. Throws
/// std::invalid_argument for an unknown mapper.
Drawn draw(
  const HardCase& hard, const HardView& view, const std::string& mapper, vtkRenderWindow* window);
} // namespace tetmarch::testing

#endif
