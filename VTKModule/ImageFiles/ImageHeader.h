// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The content of an image file's header: NRRD or MetaImage.
#ifndef TetMarchImageFilesImageHeader_h
#define TetMarchImageFilesImageHeader_h

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace tetmarch
{

/** The error of a file, as the end of a sentence that begins with the file's name. */
struct ImageFileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

enum class ImageEncoding
{
  Raw,
  Deflated, // by gzip or zlib
  Text,
  Hex
};

/** Values are ordered with x fastest, then y and z; the components of a value are adjacent. */
struct ImageHeader
{
  std::array<int, 3> Dimensions = { 1, 1, 1 };
  int Components = 1;
  int Type = VTK_VOID;
  bool BigEndian = false;
  ImageEncoding Encoding = ImageEncoding::Raw;
  std::array<double, 3> Spacing = { 1, 1, 1 };
  std::array<double, 3> Origin = { 0, 0, 0 };
  /** Row-major, as in vtkImageData: column k is the direction of axis k. */
  std::array<double, 9> Direction = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  /** The files of the values; each contains an equal part of them. */
  std::vector<std::string> Files;
  /** Bytes before the first line to be skipped, in each file. */
  std::uint64_t Begin = 0;
  std::int64_t LineSkip = 0;
  /** Bytes to be skipped after the lines; for deflated values, of the inflated bytes. -1: the
   * values are at the end. */
  std::int64_t ByteSkip = 0;
  const char* ArrayName = "";
};

using ImageVector = std::array<double, 3>;

/** Sets the dimensions from the sizes of up to three axes. Throws ImageFileError. */
void setDimensions(ImageHeader& header, const std::vector<std::int64_t>& sizes);

/** Sets spacing and directions from the steps between values along up to three axes. Throws
 * ImageFileError. */
void setSteps(ImageHeader& header, std::vector<ImageVector> steps);

/** Number of bytes of all components of all values. */
std::uint64_t countOf(const ImageHeader& header);
std::uint64_t bytesOf(const ImageHeader& header);

/** Throws ImageFileError if there are more values than can be counted. */
void checkCount(const ImageHeader& header);

/** The header of a .nrrd, .nhdr, .mha or .mhd file. Throws ImageFileError. Reads no values, and
 * doesn't check the files that contain them. */
ImageHeader readImageHeader(const std::string& path);

} // namespace tetmarch

#endif
