// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileReader.h"

#include "ErrorText.h"
#include "ExodusCheck.h"
#include "Failure.h"
#include "Messages.h"
#include "Numbers.h"
#include "Plot3DCheck.h"

#include "vtkGenericDataObjectReader.h"
#include "vtkTetMarchImageReader.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtkXMLHyperTreeGridReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"
#include "vtkXMLPartitionedDataSetReader.h"
#include "vtkXMLReader.h"
#include "vtkXMLUniformGridAMRReader.h"
#if TETMARCH_HAVE_EXODUS
#include "vtkExodusIIReader.h"
#endif
#if TETMARCH_HAVE_CGNS
#include "vtkCGNSReader.h"
#endif
#if TETMARCH_HAVE_PLOT3D
#include "vtkPlot3DMetaReader.h"
#endif

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <set>

namespace
{
template <typename Reader>
vtkSmartPointer<Reader> MakeReaderOf(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

[[maybe_unused, noreturn]] void RefuseUnbuilt(const std::string& path, const std::string& reader)
{
  tetmarch::RefuseFile(
    path, "this " + tetmarch::GetProgramName() + " was built without VTK's " + reader);
}

/// The libraries below the Exodus and CGNS readers print by themselves, or end the process, when
/// they are given another kind of file.
[[maybe_unused]] void CheckBeginning(
  const std::string& path, std::initializer_list<const char*> beginnings)
{
  std::array<char, 8> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  for (const char* beginning : beginnings)
  {
    if (std::equal(beginning, beginning + std::strlen(beginning), bytes.begin()))
    {
      return;
    }
  }
  throw tetmarch::Failure(
    "cannot read '" + path + "': the file is damaged or not of the kind that its ending says");
}

/// The readers of VTK's XML crash, or don't end, by numbers of components that are none. Looks at
/// the first of the file, where all of them are unless values come between.
void CheckComponents(const std::string& path)
{
  std::string begin(1 << 20, ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  const std::string name = "NumberOfComponents=\"";
  for (std::size_t at = begin.find(name); at != std::string::npos; at = begin.find(name, at))
  {
    at += name.size();
    const std::string number = begin.substr(at, begin.find('"', at) - at);
    constexpr int most = 1000000;
    const int components = tetmarch::ParseInteger(number).value_or(-1);
    if (components < 0 || components > most)
    {
      throw tetmarch::Failure(
        "cannot read '" + path + "': an array has '" + number.substr(0, 40) + "' components");
    }
  }
}

/// The reader of the kind of data in the file: unlike vtkXMLGenericDataObjectReader it tells of its
/// progress, and can be stopped.
vtkSmartPointer<vtkAlgorithm> MakeXMLReader(const std::string& path)
{
  auto any = MakeReaderOf<vtkXMLGenericDataObjectReader>(path);
  bool parallel = false;
  const int type = any->ReadOutputType(path.c_str(), parallel);
  const vtkSmartPointer<vtkXMLReader> own =
    type < 0 ? nullptr : vtkXMLGenericDataObjectReader::CreateReader(type, parallel);
  if (!own)
  {
    throw tetmarch::Failure(
      "cannot read '" + path + "': the file is damaged or not of the kind that its ending says");
  }
  CheckComponents(path);
  own->SetFileName(path.c_str());
  return own;
}

[[maybe_unused]] constexpr const char* HDF5Beginning = "\x89HDF\r\n\x1a\n";

/// Whose header is checked.
vtkSmartPointer<vtkAlgorithm> MakeImageReader(const std::string& path)
{
  auto reader = MakeReaderOf<vtkTetMarchImageReader>(path);
  const tetmarch::ErrorText error(reader);
  reader->UpdateInformation();
  if (!error.Get().empty())
  {
    throw tetmarch::Failure("cannot read '" + path + "': " + error.Get());
  }
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeExodusReader(const std::string& path)
{
#if TETMARCH_HAVE_EXODUS
  CheckBeginning(path, { "CDF", HDF5Beginning });
  tetmarch::CheckExodus(path);
  auto reader = MakeReaderOf<vtkExodusIIReader>(path);
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  reader->SetGenerateObjectIdCellArray(0);
  return reader;
#else
  RefuseUnbuilt(path, "Exodus reader (component IOExodus)");
#endif
}

vtkSmartPointer<vtkAlgorithm> MakeCGNSReader(const std::string& path)
{
#if TETMARCH_HAVE_CGNS
  // Newer files of ADF have the first four characters with their highest bit.
  CheckBeginning(path, { "@(#)ADF",
                         "\xC0\xA8\xA3\xA9"
                         "ADF",
                         HDF5Beginning });
  auto reader = MakeReaderOf<vtkCGNSReader>(path);
  reader->UpdateInformation();
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  return reader;
#else
  RefuseUnbuilt(path, "CGNS reader (component IOCGNSReader)");
#endif
}

vtkSmartPointer<vtkAlgorithm> MakePlot3DReader(const std::string& path)
{
#if TETMARCH_HAVE_PLOT3D
  tetmarch::CheckPlot3D(path);
  return MakeReaderOf<vtkPlot3DMetaReader>(
    std::filesystem::absolute(path).string()); // of one without a folder it takes the root's
#else
  RefuseUnbuilt(path, "PLOT3D reader (component IOParallel)");
#endif
}

vtkSmartPointer<vtkAlgorithm> MakeAMRReader(const std::string& path)
{
  CheckComponents(path);
  auto reader = MakeReaderOf<vtkXMLUniformGridAMRReader>(path);
  reader->SetMaximumLevelsToReadByDefault(0); // all
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeTreeReader(const std::string& path)
{
  CheckComponents(path);
  return MakeReaderOf<vtkXMLHyperTreeGridReader>(path);
}
} // namespace

namespace tetmarch
{

std::string GetEnding(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool IsImageFile(const std::string& path)
{
  const std::string ending = GetEnding(path);
  return ending == ".mhd" || ending == ".mha" || ending == ".nrrd" || ending == ".nhdr";
}

void CheckFile(const std::string& path)
{
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status))
  {
    throw Failure("cannot read '" + path + "': there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure("cannot read '" + path + "': it is a folder");
  }
}

vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path, const RawOptions& rawOptions)
{
  static const std::set<std::string> xml = { ".vtu", ".pvtu", ".vtm", ".vtmb", ".vtp", ".pvtp",
    ".vts", ".pvts", ".vtr", ".pvtr", ".vti", ".pvti" };
  static const std::set<std::string> exodus = { ".ex2", ".ex2v2", ".exo", ".exoii", ".e", ".g" };
  const std::string ending = GetEnding(path);
  if (xml.count(ending))
  {
    return MakeXMLReader(path);
  }
  if (ending == ".vtpc") // which vtkXMLGenericDataObjectReader doesn't know
  {
    return MakeReaderOf<vtkXMLPartitionedDataSetCollectionReader>(path);
  }
  if (ending == ".vtpd")
  {
    return MakeReaderOf<vtkXMLPartitionedDataSetReader>(path);
  }
  if (ending == ".vth" || ending == ".vthb")
  {
    return MakeAMRReader(path);
  }
  if (ending == ".htg")
  {
    return MakeTreeReader(path);
  }
  if (ending == ".p3d")
  {
    return MakePlot3DReader(path);
  }
  if (ending == ".vtk")
  {
    auto reader = MakeReaderOf<vtkGenericDataObjectReader>(path);
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
    return reader;
  }
  if (exodus.count(ending))
  {
    return MakeExodusReader(path);
  }
  if (ending == ".cgns")
  {
    return MakeCGNSReader(path);
  }
  if (IsImageFile(path))
  {
    return MakeImageReader(path);
  }
  if (IsRawFile(path) && rawOptions.Dimensions && rawOptions.Type)
  {
    return MakeRawReader(path, rawOptions);
  }
  throw Failure(
    "cannot read '" + path + "': no reader for the ending '" + ending +
    "'; known are VTK's XML files (.vtu, .vti, .vtr, .pvtu, .vtm, .vtpc, .vthb, .htg, ...), lists "
    "of "
    "files by time (.pvd, .series), legacy .vtk, "
    "MetaImage (.mhd, .mha), NRRD (.nrrd, .nhdr), raw images (.raw), Exodus (.ex2, .e, .exo, .g), "
    "CGNS (.cgns) and PLOT3D (.p3d)");
}

} // namespace tetmarch
