// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The VTK reader for a file, by the ending of its name.
 */
#ifndef tetmarch_FileReader_h
#define tetmarch_FileReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace tetmarch
{

/**
 * A reader that is set up to read everything in the file. Throws Failure if no reader is known for
 * the ending or this build has none.
 */
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path);

} // namespace tetmarch

#endif
