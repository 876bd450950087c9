// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/ImageValues.h"

#include "ImageFiles/ByteSource.h"
#include "ImageFiles/HeaderText.h"

#include "vtkAbstractArray.h"
#include "vtkByteSwap.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <vector>

namespace tetmarch
{
namespace
{

constexpr std::size_t BytesAtOnce = 1u << 20;

std::uint64_t bytesOfFile(const ImageHeader& header)
{
  return bytesOf(header) / header.Files.size();
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason)
{
  throw ImageFileError("its file of values '" + path + "' " + reason);
}

std::uint64_t lengthOf(const std::string& path)
{
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
  {
    refuse(path, std::filesystem::exists(path, code) ? "is no regular file" : "isn't there");
  }
  const std::uint64_t length = std::filesystem::file_size(path, code);
  if (code)
  {
    refuse(path, "can't be read");
  }
  return length;
}

// The file at its first value, or at the first deflated byte; Rest is the number of following
// bytes.
struct OpenFile
{
  std::ifstream Stream;
  std::uint64_t Rest = 0;
};

OpenFile openFile(const ImageHeader& header, const std::string& path)
{
  const std::uint64_t length = lengthOf(path);
  OpenFile file{ std::ifstream(path, std::ios::binary) };
  if (!file.Stream)
  {
    refuse(path, "can't be opened");
  }
  std::uint64_t begin = header.Begin;
  file.Stream.seekg(static_cast<std::streamoff>(begin));
  constexpr auto most = std::numeric_limits<std::streamsize>::max();
  for (std::int64_t line = 0; line < header.LineSkip && file.Stream; ++line)
  {
    file.Stream.ignore(most, '\n');
    begin += static_cast<std::uint64_t>(file.Stream.gcount());
  }
  if (header.ByteSkip < 0)
  {
    begin = std::max(begin, length - std::min(length, bytesOfFile(header)));
  }
  else if (header.Encoding != ImageEncoding::Deflated)
  {
    begin += static_cast<std::uint64_t>(header.ByteSkip);
  }
  file.Rest = length - std::min(length, begin);
  file.Stream.clear();
  file.Stream.seekg(static_cast<std::streamoff>(std::min(length, begin)));
  return file;
}

void checkLength(const ImageHeader& header, const std::string& path)
{
  const std::uint64_t rest = openFile(header, path).Rest;
  const std::uint64_t values = countOf(header) / header.Files.size();
  const std::uint64_t bytes = bytesOfFile(header);
  const bool fits = header.Encoding == ImageEncoding::Text ? (rest + 1) / 2 >= values
                    : header.Encoding == ImageEncoding::Hex
                      ? rest / 2 >= bytes
                      : rest >= bytes / mostInflated(header.Encoding);
  if (!fits)
  {
    throw ImageFileError("by its header there are " + std::to_string(values) + " values of " +
                         vtkImageScalarTypeNameMacro(header.Type) + " in '" + path + "', " +
                         std::to_string(bytes) + " bytes, but there are only " +
                         std::to_string(rest) +
                         (header.Encoding == ImageEncoding::Raw ? "" : " encoded ones"));
  }
}

// The state of reading one file; Total and Done refer to all files.
struct Reading
{
  const ImageHeader& Header;
  const ImageProgress& Progress;
  double Total;
  double Done = 0;

  bool add(std::size_t bytes)
  {
    this->Done += static_cast<double>(bytes);
    return this->Progress(this->Done / this->Total);
  }
};

[[noreturn]] void refuseShort(const std::string& path, std::uint64_t done, std::uint64_t all)
{
  refuse(path, "ends after " + std::to_string(done) + " of " + std::to_string(all) + " bytes");
}

void skipBytes(ByteSource& source, const std::string& path, std::uint64_t count)
{
  std::vector<unsigned char> skipped(std::min<std::uint64_t>(count, BytesAtOnce));
  for (std::uint64_t done = 0; done < count;)
  {
    const auto part = std::min<std::uint64_t>(skipped.size(), count - done);
    const std::size_t read = source.read(skipped.data(), part);
    done += read;
    if (read < part)
    {
      refuseShort(path, done, count);
    }
  }
}

bool readBytes(Reading& reading, const std::string& path, unsigned char* to)
{
  OpenFile file = openFile(reading.Header, path);
  const auto source = makeByteSource(file.Stream, reading.Header.Encoding);
  if (reading.Header.Encoding == ImageEncoding::Deflated)
  {
    skipBytes(*source, path, static_cast<std::uint64_t>(reading.Header.ByteSkip));
  }
  const std::uint64_t all = bytesOfFile(reading.Header);
  for (std::uint64_t done = 0; done < all;)
  {
    const std::size_t part = std::min<std::uint64_t>(BytesAtOnce, all - done);
    const std::size_t read = source->read(to + done, part);
    done += read;
    if (read < part)
    {
      refuseShort(path, done, all);
    }
    if (!reading.add(part))
    {
      return false;
    }
  }
  return true;
}

// A number ends at a blank or a comma.
bool nextNumber(std::istream& file, std::string& number)
{
  const auto isBetween = [](int c) { return std::isspace(c) || c == ','; };
  number.clear();
  int character = file.get();
  while (isBetween(character))
  {
    character = file.get();
  }
  constexpr std::size_t longest = 400;
  for (; character != std::istream::traits_type::eof() && !isBetween(character) &&
         number.size() < longest;
       character = file.get())
  {
    number += static_cast<char>(character);
  }
  return !number.empty();
}

template <typename Value>
bool readText(Reading& reading, const std::string& path, Value* to)
{
  OpenFile file = openFile(reading.Header, path);
  const std::uint64_t all = countOf(reading.Header) / reading.Header.Files.size();
  std::string text;
  for (std::uint64_t i = 0; i < all; ++i)
  {
    if (!nextNumber(file.Stream, text))
    {
      refuse(path, "ends after " + std::to_string(i) + " of " + std::to_string(all) + " values");
    }
    const auto number = numberOf<Value>(text.data(), text.data() + text.size());
    if (!number)
    {
      refuse(path, "has '" + shown(text) + "', which is no value of " +
                     vtkImageScalarTypeNameMacro(reading.Header.Type));
    }
    to[i] = *number;
    constexpr std::uint64_t valuesAtOnce = 1u << 16;
    if (i % valuesAtOnce == valuesAtOnce - 1 && !reading.add(valuesAtOnce * sizeof(Value)))
    {
      return false;
    }
  }
  return true;
}

bool readFile(Reading& reading, const std::string& path, unsigned char* to)
{
  if (reading.Header.Encoding != ImageEncoding::Text)
  {
    return readBytes(reading, path, to);
  }
  switch (reading.Header.Type)
  {
    vtkTemplateMacro(return readText(reading, path, reinterpret_cast<VTK_TT*>(to)));
  }
  return false;
}

} // namespace

void checkImageFiles(const ImageHeader& header)
{
  if (countOf(header) % header.Files.size() != 0)
  {
    throw ImageFileError("its header names " + std::to_string(header.Files.size()) +
                         " files, which can't have equal parts of its " +
                         std::to_string(countOf(header)) + " values");
  }
  for (const std::string& path : header.Files)
  {
    checkLength(header, path);
  }
}

bool readImageValues(const ImageHeader& header, void* values, const ImageProgress& progress)
{
  Reading reading{ header, progress, static_cast<double>(bytesOf(header)) };
  auto* to = static_cast<unsigned char*>(values);
  for (const std::string& path : header.Files)
  {
    if (!readFile(reading, path, to))
    {
      return false;
    }
    to += bytesOfFile(header);
  }
#ifdef VTK_WORDS_BIGENDIAN
  constexpr bool bigEndian = true;
#else
  constexpr bool bigEndian = false;
#endif
  const bool isText = header.Encoding == ImageEncoding::Text;
  const int size = vtkAbstractArray::GetDataTypeSize(header.Type);
  if (!isText && size > 1 && header.BigEndian != bigEndian)
  {
    vtkByteSwap::SwapVoidRange(values, countOf(header), static_cast<std::size_t>(size));
  }
  return true;
}

} // namespace tetmarch
