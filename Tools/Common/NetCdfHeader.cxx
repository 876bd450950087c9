// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NetCdfHeader.h"

#include "Failure.h"

#include <array>
#include <filesystem>
#include <fstream>

// The format: https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html
namespace
{
using namespace tetmarch;

constexpr std::uint64_t MostBytes = std::uint64_t(1) << 62;

int GetSize(int type)
{
  constexpr std::array sizes = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
  return type > 0 && type < static_cast<int>(sizes.size()) ? sizes[type] : 0;
}

class HeaderReader
{
public:
  explicit HeaderReader(const std::string& path)
    : Path(path)
    , File(path, std::ios::binary)
    , Length(std::filesystem::file_size(path))
  {
  }

  NetCdfHeader Read()
  {
    this->Version = static_cast<int>(this->ReadNumber(4) & 0xff);
    const std::uint64_t records = this->ReadCount();
    NetCdfHeader header;
    std::vector<std::string> names;
    for (std::uint64_t n = this->ReadList(10); n > 0; --n)
    {
      names.push_back(this->ReadName());
      header.Dimensions[names.back()] = this->ReadCount();
    }
    this->ReadAttributes();
    for (std::uint64_t n = this->ReadList(11); n > 0; --n)
    {
      const std::string name = this->ReadName();
      header.Variables[name] = this->ReadVariable(names, header.Dimensions);
    }
    this->CheckLengths(header, records);
    return header;
  }

private:
  [[noreturn]] void Refuse(const std::string& what) const { RefuseFile(this->Path, what); }

  std::uint64_t ReadNumber(int bytes)
  {
    std::array<unsigned char, 8> read{};
    this->File.read(reinterpret_cast<char*>(read.data()), bytes);
    if (!this->File)
    {
      this->Refuse("it ends in its header");
    }
    std::uint64_t number = 0;
    for (int i = 0; i < bytes; ++i)
    {
      number = number << 8 | read[i];
    }
    return number;
  }

  std::uint64_t ReadCount() { return this->ReadNumber(this->Version == 5 ? 8 : 4); }

  /// A count of what takes at least a byte each.
  std::uint64_t ReadLength()
  {
    const std::uint64_t length = this->ReadCount();
    if (length > this->Length)
    {
      this->Refuse("its header has a list that is longer than the file");
    }
    return length;
  }

  std::uint64_t ReadList(std::uint64_t wanted)
  {
    const std::uint64_t tag = this->ReadNumber(4);
    const std::uint64_t count = this->ReadLength();
    if (tag != wanted && (tag != 0 || count != 0))
    {
      this->Refuse("its header is damaged");
    }
    return count;
  }

  std::string ReadBytes(std::uint64_t count)
  {
    const std::uint64_t padded = (count + 3) / 4 * 4;
    if (count > this->Length)
    {
      this->Refuse("its header has a text that is longer than the file");
    }
    std::string bytes(padded, ' ');
    this->File.read(bytes.data(), static_cast<std::streamsize>(padded));
    if (!this->File)
    {
      this->Refuse("it ends in its header");
    }
    bytes.resize(count);
    return bytes;
  }

  std::string ReadName() { return this->ReadBytes(this->ReadLength()); }

  std::map<std::string, std::string> ReadAttributes()
  {
    std::map<std::string, std::string> texts;
    for (std::uint64_t n = this->ReadList(12); n > 0; --n)
    {
      const std::string name = this->ReadName();
      const int type = static_cast<int>(this->ReadNumber(4));
      const std::string bytes = this->ReadBytes(this->ReadLength() * GetSize(type));
      constexpr int ofText = 2;
      if (type == ofText)
      {
        texts[name] = bytes.substr(0, bytes.find('\0'));
      }
    }
    return texts;
  }

  NetCdfVariable ReadVariable(
    const std::vector<std::string>& names, const std::map<std::string, std::uint64_t>& dimensions)
  {
    NetCdfVariable variable;
    double values = 1.0;
    for (std::uint64_t n = this->ReadLength(); n > 0; --n)
    {
      const std::uint64_t number = this->ReadCount();
      if (number >= names.size())
      {
        this->Refuse("its header names dimension " + std::to_string(number) + " of " +
                     std::to_string(names.size()));
      }
      const std::uint64_t length = dimensions.at(names[number]);
      const bool ofRecords = length == 0 && variable.Dimensions.empty();
      values *= ofRecords ? 1.0 : static_cast<double>(length);
      variable.Dimensions.push_back(names[number]);
    }
    variable.Texts = this->ReadAttributes();
    variable.Type = static_cast<int>(this->ReadNumber(4));
    const int size = GetSize(variable.Type);
    this->ReadCount(); // its size, which may be too large for the field
    variable.Begin = this->ReadNumber(this->Version == 1 ? 4 : 8);
    if (size == 0 || !(values * size < static_cast<double>(MostBytes)))
    {
      this->Refuse(size == 0 ? "its header has a type that there is not"
                             : "its header has more values than can be counted");
    }
    variable.Bytes = static_cast<std::uint64_t>(values) * size;
    return variable;
  }

  void CheckLengths(const NetCdfHeader& header, std::uint64_t records) const
  {
    const auto isOfRecords = [&](const NetCdfVariable& variable) {
      return !variable.Dimensions.empty() && header.Dimensions.at(variable.Dimensions.front()) == 0;
    };
    double record = 0.0; // bytes
    for (const auto& [name, variable] : header.Variables)
    {
      record += isOfRecords(variable) ? static_cast<double>((variable.Bytes + 3) / 4 * 4) : 0.0;
    }
    const bool isStreamed = records >= 0xffffffff;
    for (const auto& [name, variable] : header.Variables)
    {
      double end = static_cast<double>(variable.Begin) + static_cast<double>(variable.Bytes);
      if (isOfRecords(variable))
      {
        end = records == 0 || isStreamed ? 0.0 : end + static_cast<double>(records - 1) * record;
      }
      if (end > static_cast<double>(this->Length) && record + variable.Bytes > 0)
      {
        this->Refuse("by its header '" + name + "' ends at byte " +
                     std::to_string(static_cast<std::uint64_t>(end)) + ", but the file has " +
                     std::to_string(this->Length));
      }
    }
  }

  std::string Path;
  std::ifstream File;
  std::uint64_t Length;
  int Version = 1;
};
} // namespace

namespace tetmarch
{

bool IsClassicNetCdf(const std::string& path)
{
  std::array<char, 4> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  return bytes[0] == 'C' && bytes[1] == 'D' && bytes[2] == 'F' &&
         (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

NetCdfHeader ReadNetCdfHeader(const std::string& path) { return HeaderReader(path).Read(); }

} // namespace tetmarch
