// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExodusCheck.h"

#include "Failure.h"
#include "NetCdfHeader.h"

#include "vtkByteSwap.h"

#include <algorithm>
#include <fstream>

namespace
{
using namespace tetmarch;

std::uint64_t GetDimension(const NetCdfHeader& header, const std::string& name)
{
  const auto found = header.Dimensions.find(name);
  return found == header.Dimensions.end() ? 0 : found->second;
}

/// All of them are from 1 to a number.
template <typename Id>
void CheckIds(const std::string& path, const std::string& name, const NetCdfVariable& variable,
  std::uint64_t number)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(variable.Begin));
  std::vector<Id> ids(65536);
  for (std::uint64_t left = variable.Bytes / sizeof(Id); left > 0;)
  {
    const std::size_t part = std::min<std::uint64_t>(left, ids.size());
    file.read(reinterpret_cast<char*>(ids.data()), static_cast<std::streamsize>(part * sizeof(Id)));
    vtkByteSwap::SwapBERange(ids.data(), part);
    const auto wrong = std::find_if(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(part),
      [&](Id id) { return id < 1 || static_cast<std::uint64_t>(id) > number; });
    if (wrong != ids.begin() + static_cast<std::ptrdiff_t>(part))
    {
      RefuseFile(path,
        "'" + name + "' names point " + std::to_string(*wrong) + " of " + std::to_string(number));
    }
    left -= part;
  }
}

void CheckBlock(const std::string& path, const NetCdfHeader& header, const std::string& number)
{
  const std::string name = "connect" + number;
  const auto found = header.Variables.find(name);
  if (found == header.Variables.end())
  {
    return; // of no cells, or of faces
  }
  const NetCdfVariable& variable = found->second;
  const auto type = variable.Texts.find("elem_type");
  std::string kind = type == variable.Texts.end() ? "" : type->second;
  std::transform(kind.begin(), kind.end(), kind.begin(), ::toupper);
  if (kind == "NFACED" || kind == "NSIDED")
  {
    return;
  }
  const std::vector<std::string> dimensions = { "num_el_in_blk" + number,
    "num_nod_per_el" + number };
  constexpr int ofInt = 4;
  constexpr int ofInt64 = 10;
  if (variable.Dimensions != dimensions || (variable.Type != ofInt && variable.Type != ofInt64))
  {
    RefuseFile(
      path, "'" + name + "' is not of " + dimensions[0] + " times " + dimensions[1] + " ids");
  }
  const std::uint64_t points = GetDimension(header, "num_nodes");
  variable.Type == ofInt ? CheckIds<std::int32_t>(path, name, variable, points)
                         : CheckIds<std::int64_t>(path, name, variable, points);
}
} // namespace

namespace tetmarch
{

void CheckExodus(const std::string& path)
{
  if (!IsClassicNetCdf(path))
  {
    return;
  }
  const NetCdfHeader header = ReadNetCdfHeader(path);
  const std::uint64_t blocks = GetDimension(header, "num_el_blk");
  if (blocks > header.Variables.size() + header.Dimensions.size())
  {
    RefuseFile(
      path, "its header tells of " + std::to_string(blocks) + " blocks without their sizes");
  }
  std::uint64_t cells = 0;
  for (std::uint64_t block = 1; block <= blocks; ++block)
  {
    cells += GetDimension(header, "num_el_in_blk" + std::to_string(block));
    CheckBlock(path, header, std::to_string(block));
  }
  if (cells != GetDimension(header, "num_elem"))
  {
    RefuseFile(path, "its blocks have " + std::to_string(cells) + " cells, but all of it has " +
                       std::to_string(GetDimension(header, "num_elem")));
  }
}

} // namespace tetmarch
