// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The bytes of the values in a file, as they are, deflated or in hexadecimal digits.
#ifndef TetMarchImageFilesByteSource_h
#define TetMarchImageFilesByteSource_h

#include "ImageFiles/ImageHeader.h"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>

namespace tetmarch
{

class ByteSource
{
public:
  virtual ~ByteSource() = default;
  /** Up to this number of bytes; fewer only at the end. Throws ImageFileError. */
  virtual std::size_t read(unsigned char* to, std::size_t count) = 0;
};

/** From where the file is. The file must live as long. */
std::unique_ptr<ByteSource> makeByteSource(std::istream& file, ImageEncoding encoding);

/** How many bytes a byte of a file can become. */
std::uint64_t mostInflated(ImageEncoding encoding);

} // namespace tetmarch

#endif
