// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pictures as files.
 */
#ifndef tetmarch_PngFile_h
#define tetmarch_PngFile_h

#include <string>

class vtkImageData;

namespace tetmarch
{

/// Colours that are multiplied by their opacity, as the GL blends them, become those of PNG files:
/// as they would be if they were opaque.
void DivideByOpacity(vtkImageData* rgba);

/// Throws Failure if the file can't be written.
void WritePng(const std::string& path, vtkImageData* picture);

} // namespace tetmarch

#endif
