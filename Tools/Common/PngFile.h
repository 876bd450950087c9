// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pictures as the bytes of files.
 */
#ifndef tetmarch_PngFile_h
#define tetmarch_PngFile_h

#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string_view>

class vtkImageData;

namespace tetmarch
{

/// Colours that are multiplied by their opacity, as the GL blends them, become those of PNG files:
/// as they would be if they were opaque.
void DivideByOpacity(vtkImageData* rgba);

/// The bytes of a PNG file. Throws Failure, of a picture that has no pixels.
vtkSmartPointer<vtkUnsignedCharArray> EncodePng(vtkImageData* picture);

std::string_view GetBytes(vtkUnsignedCharArray* bytes);

} // namespace tetmarch

#endif
