// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The VTK reader for a file, by the ending of its name.
 */
#ifndef tetmarch_FileReader_h
#define tetmarch_FileReader_h

#include "RawImage.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace tetmarch
{

/// With its dot, in lower case.
std::string GetEnding(const std::string& path);

/// Of MetaImage or NRRD, by the ending of its name.
bool IsImageFile(const std::string& path);

/// Throws Failure if there is no such file.
void CheckFile(const std::string& path);

/**
 * A reader that is set up to read everything in the file. The options are those of a raw file, and
 * complete. Throws Failure if no reader is known for the ending or this build has none.
 */
vtkSmartPointer<vtkAlgorithm> MakeReader(
  const std::string& path, const RawOptions& rawOptions = {});

} // namespace tetmarch

#endif
