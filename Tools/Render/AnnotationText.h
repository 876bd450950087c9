// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Text beside the volume, and how much room it takes.
 */
#ifndef tetmarch_AnnotationText_h
#define tetmarch_AnnotationText_h

#include <array>
#include <string>

class vtkTextProperty;

namespace tetmarch
{

/// Plain text of a colour, of a size in pixels.
void SetUpText(vtkTextProperty* text, const std::array<double, 3>& color, double size);

/// Width and height in pixels.
std::array<int, 2> MeasureText(const std::string& text, vtkTextProperty* property);

} // namespace tetmarch

#endif
