// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/ByteSource.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace tetmarch
{
namespace
{

std::size_t readFrom(std::istream& file, unsigned char* to, std::size_t count)
{
  file.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
  return static_cast<std::size_t>(file.gcount());
}

class PlainBytes : public ByteSource
{
public:
  explicit PlainBytes(std::istream& file)
    : File(file)
  {
  }
  std::size_t read(unsigned char* to, std::size_t count) override
  {
    return readFrom(this->File, to, count);
  }

private:
  std::istream& File;
};

// gzip or zlib; concatenated streams are read as one.
class InflatedBytes : public ByteSource
{
public:
  explicit InflatedBytes(std::istream& file)
    : File(file)
  {
    constexpr int anyHeader = 32;
    if (inflateInit2(&this->Stream, MAX_WBITS + anyHeader) != Z_OK)
    {
      throw ImageFileError("there is not enough memory to inflate its values");
    }
  }
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;
  ~InflatedBytes() override { inflateEnd(&this->Stream); }

  std::size_t read(unsigned char* to, std::size_t count) override
  {
    std::size_t done = 0;
    while (done < count && this->fill())
    {
      const std::size_t most = std::min<std::size_t>(count - done, 1u << 30);
      this->Stream.next_out = to + done;
      this->Stream.avail_out = static_cast<uInt>(most);
      const int status = inflate(&this->Stream, Z_NO_FLUSH);
      done += most - this->Stream.avail_out;
      if (status == Z_STREAM_END)
      {
        inflateReset(&this->Stream);
      }
      else if (status != Z_OK && status != Z_BUF_ERROR)
      {
        throw ImageFileError("its compressed values are damaged");
      }
    }
    return done;
  }

private:
  // Whether there is more to inflate.
  bool fill()
  {
    if (this->Stream.avail_in == 0)
    {
      this->Stream.next_in = this->Input.data();
      this->Stream.avail_in =
        static_cast<uInt>(readFrom(this->File, this->Input.data(), this->Input.size()));
    }
    return this->Stream.avail_in > 0 || this->Stream.avail_out == 0;
  }

  std::istream& File;
  z_stream Stream{};
  std::array<unsigned char, 65536> Input;
};

class HexBytes : public ByteSource
{
public:
  explicit HexBytes(std::istream& file)
    : File(file)
  {
  }
  std::size_t read(unsigned char* to, std::size_t count) override
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const int high = this->nextDigit();
      const int low = high < 0 ? -1 : this->nextDigit();
      if (low < 0)
      {
        return i;
      }
      to[i] = static_cast<unsigned char>(16 * high + low);
    }
    return count;
  }

private:
  // -1 at the end.
  int nextDigit()
  {
    int character = this->File.get();
    while (std::isspace(character))
    {
      character = this->File.get();
    }
    if (character != std::istream::traits_type::eof() && !std::isxdigit(character))
    {
      throw ImageFileError("its values are no hexadecimal digits");
    }
    return character == std::istream::traits_type::eof() ? -1
           : std::isdigit(character)                     ? character - '0'
                                                         : std::tolower(character) - 'a' + 10;
  }

  std::istream& File;
};

} // namespace

std::unique_ptr<ByteSource> makeByteSource(std::istream& file, ImageEncoding encoding)
{
  switch (encoding)
  {
    case ImageEncoding::Deflated:
      return std::make_unique<InflatedBytes>(file);
    case ImageEncoding::Hex:
      return std::make_unique<HexBytes>(file);
    default:
      return std::make_unique<PlainBytes>(file);
  }
}

std::uint64_t mostInflated(ImageEncoding encoding)
{
  return encoding == ImageEncoding::Deflated ? 1032 : 1; // of deflate: https://zlib.net/zlib_tech
}

} // namespace tetmarch
