// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The bytes of the values in a file, raw, deflated or in hexadecimal digits.
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
  /** Reads up to this number of bytes; fewer only at the end. Throws ImageFileError. */
  virtual std::size_t read(unsigned char* to, std::size_t count) = 0;
};

/** A source at the current position of the file, which must outlive it. */
std::unique_ptr<ByteSource> makeByteSource(std::istream& file, ImageEncoding encoding);

/** Maximum number of bytes per byte of a file. */
std::uint64_t mostInflated(ImageEncoding encoding);

} // namespace tetmarch

#endif
