// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The header of a netCDF file in the classic format, in which most Exodus files are.
 */
#ifndef tetmarch_NetCdfHeader_h
#define tetmarch_NetCdfHeader_h

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tetmarch
{

struct NetCdfVariable
{
  std::vector<std::string> Dimensions;
  std::map<std::string, std::string> Texts; // attributes that are text
  int Type = 0;                             // of netCDF: 4 is an int of 32 bits, 10 of 64
  std::uint64_t Begin = 0;                  // in the file
  std::uint64_t Bytes = 0;                  // of one record, if its first dimension is of records
};

struct NetCdfHeader
{
  std::map<std::string, std::uint64_t> Dimensions; // 0: of records
  std::map<std::string, NetCdfVariable> Variables;
};

/// Whether the file begins as one in the classic format, not as one in HDF5.
bool IsClassicNetCdf(const std::string& path);

/// Throws Failure if the header contradicts itself or the length of the file.
NetCdfHeader ReadNetCdfHeader(const std::string& path);

} // namespace tetmarch

#endif
