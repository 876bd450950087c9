// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the header of an image file says: NRRD or MetaImage.
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

/** What is wrong with a file, as the end of a sentence that names the file. */
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

/** Values are along x first, then along y and z; the components of a value follow each other. */
struct ImageHeader
{
  std::array<int, 3> Dimensions = { 1, 1, 1 };
  int Components = 1;
  int Type = VTK_VOID;
  bool BigEndian = false;
  ImageEncoding Encoding = ImageEncoding::Raw;
  std::array<double, 3> Spacing = { 1, 1, 1 };
  std::array<double, 3> Origin = { 0, 0, 0 };
  /** Row by row, as vtkImageData has it: column k is the direction of axis k. */
  std::array<double, 9> Direction = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  /** The files of the values; each has an equal part of them. */
  std::vector<std::string> Files;
  /** In each file: bytes before the first line to be skipped. */
  std::uint64_t Begin = 0;
  std::int64_t LineSkip = 0;
  /** After the lines; of deflated values, of the inflated bytes. -1: the values are at the end. */
  std::int64_t ByteSkip = 0;
  const char* ArrayName = "";
};

using ImageVector = std::array<double, 3>;

/** From the sizes of up to three axes. Throws ImageFileError. */
void setDimensions(ImageHeader& header, const std::vector<std::int64_t>& sizes);

/** From the vectors from one value to the next along up to three axes. Throws ImageFileError. */
void setSteps(ImageHeader& header, std::vector<ImageVector> steps);

/** Of all components of all values. */
std::uint64_t countOf(const ImageHeader& header);
std::uint64_t bytesOf(const ImageHeader& header);

/** Throws ImageFileError if there are more values than can be counted. */
void checkCount(const ImageHeader& header);

/** Of a file whose name ends in .nrrd, .nhdr, .mha or .mhd. Throws ImageFileError. Reads no values,
 * and doesn't look for the files that have them. */
ImageHeader readImageHeader(const std::string& path);

} // namespace tetmarch

#endif
