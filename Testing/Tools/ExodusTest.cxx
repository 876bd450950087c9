// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of Exodus that contradict themselves, for which VTK's reader crashes.
#include "ReaderCase.h"
#include "TestGrids.h"

#include "NetCdfHeader.h"

#include "vtkDoubleArray.h"
#include "vtkExodusIIWriter.h"
#include "vtkPointData.h"

#include <sstream>

namespace
{
class ExodusFile : public ReaderCase
{
protected:
  void SetUp() override
  {
    ReaderCase::SetUp();
    auto voxel = MakeVoxel(0.0);
    AddArray<vtkDoubleArray>(voxel->GetPointData(), "a", 8);
    this->Path = this->Write<vtkExodusIIWriter>("sound.ex2", voxel);
    std::ostringstream bytes;
    bytes << std::ifstream(this->Path, std::ios::binary).rdbuf();
    this->Bytes = bytes.str();
  }

  static void Put(std::string& bytes, std::size_t at, unsigned value)
  {
    for (int i = 0; i < 4; ++i)
    {
      bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
    }
  }

  // The length follows the name, which ends at a multiple of four bytes.
  std::string WithDimension(const std::string& name, unsigned length) const
  {
    std::string changed = this->Bytes;
    const std::size_t at = changed.find(name);
    EXPECT_NE(at, std::string::npos) << name;
    Put(changed, at + (name.size() + 3) / 4 * 4, length);
    return changed;
  }

  std::string WithId(int place, unsigned id) const
  {
    std::string changed = this->Bytes;
    const auto header = tetmarch::ReadNetCdfHeader(this->Path);
    Put(changed, header.Variables.at("connect1").Begin + 4 * place, id);
    return changed;
  }

  std::string Path;
  std::string Bytes;
};
} // namespace

TEST_F(ExodusFile, MustNotContradictItself)
{
  EXPECT_EQ(GetError(this->Path), "accepted");
  for (const auto& [bytes, words] :
    { std::pair<std::string, std::string>{ this->Bytes.substr(0, 200), "it ends in its header" },
      { this->Bytes.substr(0, this->Bytes.size() - 100), ", but the file has " },
      { this->WithDimension("num_nodes", 1000000000), ", but the file has " },
      { this->WithDimension("num_nodes", 7), "'connect1' names point 8 of 7" },
      { this->WithDimension("num_elem", 2), "its blocks have 1 cells, but all of it has 2" },
      { this->WithDimension("num_el_blk", 4000000000), "the file has" },
      { this->WithId(0, 9), "'connect1' names point 9 of 8" },
      { this->WithId(7, 0), "'connect1' names point 0 of 8" },
      { this->WithId(3, 0x80000000), "'connect1' names point -2147483648 of 8" } })
  {
    const std::string path = this->WriteText("a.ex2", bytes);
    EXPECT_NE(GetError(path).find(words), std::string::npos)
      << GetError(path) << " instead of " << words;
  }
}
