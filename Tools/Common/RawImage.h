// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files with only the values of an image; the user specifies their type and dimensions.
 */
#ifndef tetmarch_RawImage_h
#define tetmarch_RawImage_h

#include "vtkImageReader2.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

namespace tetmarch
{

/// What isn't given is found in the name of the file, if that is like those of the Open SciVis
/// datasets: NAME_256x256x178_uint16.raw.
struct RawOptions
{
  std::optional<std::array<int, 3>> Dimensions; // values along x, which vary fastest, y and z
  std::optional<int> Type;                      // of VTK
  std::optional<std::array<double, 3>> Spacing; // 1,1,1 by default
  bool BigEndian = false;

  bool AreGiven() const
  {
    return this->Dimensions || this->Type || this->Spacing || this->BigEndian;
  }
};

/// Each throws UsageError.
std::array<int, 3> ParseDimensions(const std::string& value);
int ParseType(const std::string& value);
std::array<double, 3> ParseSpacing(const std::string& value);

/// By the ending of its name.
bool IsRawFile(const std::string& path);

/// What is given, and what the name of the file says beside that. Throws UsageError if dimensions
/// or type are neither given nor in the name, or if options are given for a file that is not raw.
RawOptions CompleteRawOptions(const RawOptions& options, const std::string& path);

/// Of complete options. Throws Failure if the file has not the size that they call for.
vtkSmartPointer<vtkImageReader2> MakeRawReader(const std::string& path, const RawOptions& options);

} // namespace tetmarch

#endif
