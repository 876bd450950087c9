// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RawImage.h"

#include "Failure.h"
#include "FileReader.h"
#include "Numbers.h"
#include "OptionValues.h"

#include "vtkAbstractArray.h"
#include "vtkType.h"

#include <cstdint>
#include <filesystem>
#include <regex>

namespace
{
using tetmarch::Failure;
using tetmarch::RawOptions;
using tetmarch::UsageError;

struct NamedType
{
  const char* Name;
  int Type;
};

constexpr NamedType Types[] = { { "uint8", VTK_UNSIGNED_CHAR }, { "int8", VTK_SIGNED_CHAR },
  { "uint16", VTK_UNSIGNED_SHORT }, { "int16", VTK_SHORT }, { "uint32", VTK_UNSIGNED_INT },
  { "int32", VTK_INT }, { "uint64", VTK_UNSIGNED_LONG_LONG }, { "int64", VTK_LONG_LONG },
  { "float", VTK_FLOAT }, { "double", VTK_DOUBLE }, { "float32", VTK_FLOAT },
  { "float64", VTK_DOUBLE } };

std::string NameOf(int type)
{
  for (const NamedType& named : Types)
  {
    if (named.Type == type)
    {
      return named.Name;
    }
  }
  return "unknown";
}

void CompleteByName(RawOptions& options, const std::string& path)
{
  static const std::regex pattern("_(\\d+)x(\\d+)x(\\d+)_([a-z]+\\d*)$");
  const std::string stem = std::filesystem::path(path).stem().string();
  std::smatch parts;
  if (!std::regex_search(stem, parts, pattern))
  {
    return;
  }
  const auto refuse = [&](const std::string& what, const std::string& text, const char* option,
                        const UsageError& error)
  {
    throw UsageError("the name of '" + path + "' says that its " + what + " " + text + ", but " +
                     error.what() + "; " + option + " overrides the name");
  };
  if (!options.Dimensions)
  {
    const std::string text = parts[1].str() + "," + parts[2].str() + "," + parts[3].str();
    try
    {
      options.Dimensions = tetmarch::ParseDimensions(text);
    }
    catch (const UsageError& error)
    {
      refuse("dimensions are", text, "--dimensions", error);
    }
  }
  if (!options.Type)
  {
    try
    {
      options.Type = tetmarch::ParseType(parts[4]);
    }
    catch (const UsageError& error)
    {
      refuse("type is", parts[4], "--type", error);
    }
  }
}

void CheckSize(const std::string& path, const RawOptions& options)
{
  const auto& [nx, ny, nz] = *options.Dimensions;
  std::error_code code;
  const std::uint64_t there = std::filesystem::file_size(path, code);
  const std::uint64_t wanted =
    std::uint64_t(nx) * ny * nz * vtkAbstractArray::GetDataTypeSize(*options.Type);
  if (code || there != wanted)
  {
    throw Failure("cannot read '" + path + "': it has " + std::to_string(code ? 0 : there) +
                  " bytes, but " + std::to_string(nx) + " x " + std::to_string(ny) + " x " +
                  std::to_string(nz) + " values of " + NameOf(*options.Type) + " are " +
                  std::to_string(wanted) + "; check --dimensions and --type");
  }
}
} // namespace

namespace tetmarch
{

std::array<int, 3> ParseDimensions(const std::string& value)
{
  constexpr int most = 65536;
  std::array<int, 3> dimensions;
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k)
  {
    const std::size_t end = k < 2 ? value.find(',', begin) : value.size();
    const auto number =
      end == std::string::npos ? std::nullopt : ParseInteger(value.substr(begin, end - begin));
    if (!number || *number < 1 || *number > most)
    {
      throw UsageError("expected NX,NY,NZ, three whole numbers from 1 to " + std::to_string(most));
    }
    dimensions[k] = *number;
    begin = end + 1;
  }
  return dimensions;
}

int ParseType(const std::string& value)
{
  std::vector<std::string> names;
  for (const NamedType& named : Types)
  {
    names.push_back(named.Name);
  }
  return Types[ParseWord(value, names)].Type;
}

std::array<double, 3> ParseSpacing(const std::string& value)
{
  const auto spacing = ParseList(value, { 3 });
  for (double distance : spacing)
  {
    if (!(distance > 0.0))
    {
      throw UsageError("expected three numbers above 0");
    }
  }
  return { { spacing[0], spacing[1], spacing[2] } };
}

bool IsRawFile(const std::string& path) { return GetEnding(path) == ".raw"; }

RawOptions CompleteRawOptions(const RawOptions& options, const std::string& path)
{
  RawOptions complete = options;
  if (!IsRawFile(path))
  {
    if (options.AreGiven())
    {
      throw UsageError("--dimensions, --type, --spacing and --big-endian tell of .raw files; '" +
                       path + "' says these things itself");
    }
    return complete;
  }
  CompleteByName(complete, path);
  if (!complete.Dimensions || !complete.Type)
  {
    throw UsageError("'" + path + "' holds nothing but values: say what they are by " +
                     (complete.Dimensions ? ""
                       : complete.Type    ? "--dimensions NX,NY,NZ"
                                          : "--dimensions NX,NY,NZ and ") +
                     (complete.Type ? "" : "--type TYPE"));
  }
  return complete;
}

vtkSmartPointer<vtkImageReader2> MakeRawReader(const std::string& path, const RawOptions& options)
{
  CheckSize(path, options);
  const auto& [nx, ny, nz] = *options.Dimensions;
  auto reader = vtkSmartPointer<vtkImageReader2>::New();
  reader->SetFileName(path.c_str());
  reader->SetFileDimensionality(3);
  reader->SetFileLowerLeft(true); // else it turns y round
  reader->SetHeaderSize(0);
  reader->SetDataExtent(0, nx - 1, 0, ny - 1, 0, nz - 1);
  reader->SetDataScalarType(*options.Type);
  reader->SetNumberOfScalarComponents(1);
  const std::array<double, 3> spacing = options.Spacing.value_or(std::array{ 1.0, 1.0, 1.0 });
  reader->SetDataSpacing(spacing.data());
  options.BigEndian ? reader->SetDataByteOrderToBigEndian()
                    : reader->SetDataByteOrderToLittleEndian();
  return reader;
}

} // namespace tetmarch
