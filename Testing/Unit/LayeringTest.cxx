// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Includes go down the floors of VTKModule/floors.txt, and OpenGL stays on the top floor.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
namespace fs = std::filesystem;

const fs::path Module = TETMARCH_MODULE_DIR;
constexpr int TopFloor = 11;
constexpr int PublicFloor = 10; // from here on rooms know the public classes

std::map<std::string, int> readFloors()
{
  std::map<std::string, int> floors;
  std::ifstream list(Module / "floors.txt");
  for (std::string line; std::getline(list, line);)
  {
    std::istringstream words(line);
    int floor = 0;
    std::string room;
    if (words >> floor >> room)
    {
      floors[room] = floor;
    }
  }
  return floors;
}

struct Include
{
  std::string File; // from the folder VTKModule
  int Line = 0;
  std::string Included;
};

// The files that a file includes by #include "...".
std::vector<Include> includesOf(const fs::path& path)
{
  const std::string directive = "#include \"";
  std::vector<Include> found;
  std::ifstream file(path);
  int number = 0;
  for (std::string line; std::getline(file, line);)
  {
    ++number;
    if (line.compare(0, directive.size(), directive) == 0)
    {
      const std::string name = line.substr(directive.size());
      found.push_back(
        { path.lexically_relative(Module).string(), number, name.substr(0, name.find('"')) });
    }
  }
  return found;
}

bool isSource(const fs::path& path)
{
  return path.extension() == ".h" || path.extension() == ".cxx";
}

// The includes of all files of the folders.
std::vector<Include> allIncludes()
{
  std::vector<Include> found;
  for (const auto& [room, floor] : readFloors())
  {
    for (const auto& entry : fs::directory_iterator(Module / room))
    {
      if (isSource(entry.path()))
      {
        const std::vector<Include> ofFile = includesOf(entry.path());
        found.insert(found.end(), ofFile.begin(), ofFile.end());
      }
    }
  }
  return found;
}

// What is wrong with an include, or nothing.
std::string complaint(const Include& include, const std::map<std::string, int>& floors)
{
  const std::string place =
    include.File + ":" + std::to_string(include.Line) + " includes " + include.Included;
  const std::string room = fs::path(include.File).begin()->string();
  const std::string other = fs::path(include.Included).begin()->string();
  const bool ofRoom = floors.count(other) > 0;
  if (ofRoom && other != room && floors.at(other) >= floors.at(room))
  {
    return place + ", which is not on a lower floor";
  }
  if (floors.at(room) < PublicFloor && !ofRoom && fs::exists(Module / include.Included))
  {
    return place + ", a public class, which is above this floor";
  }
  if (!ofRoom && fs::exists(Module / room / include.Included))
  {
    return place + " without its room";
  }
  if (include.Included.find("OpenGL") != std::string::npos && room != "GL")
  {
    return place + ", but only GL knows OpenGL";
  }
  return {};
}

TEST(Layering, FloorsNameEveryRoom)
{
  const std::map<std::string, int> floors = readFloors();
  for (const auto& entry : fs::directory_iterator(Module))
  {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name != "Python")
    {
      EXPECT_EQ(floors.count(name), 1u) << name << " is on no floor of floors.txt";
    }
  }
  for (const auto& [room, floor] : floors)
  {
    EXPECT_TRUE(fs::is_directory(Module / room)) << room << " is no folder of VTKModule";
    EXPECT_GE(floor, 0);
    EXPECT_LE(floor, TopFloor);
  }
  EXPECT_GE(floors.size(), 17u);
}

TEST(Layering, IncludesGoDown)
{
  const std::map<std::string, int> floors = readFloors();
  const std::vector<Include> includes = allIncludes();
  for (const Include& include : includes)
  {
    EXPECT_EQ(complaint(include, floors), "");
  }
  EXPECT_GT(includes.size(), 500u);
}

// vtkSMPTools::For() loses exceptions.
TEST(Layering, LoopsInThreadsAreThoseOfParallelFor)
{
  int loops = 0;
  for (const auto& entry : fs::recursive_directory_iterator(Module))
  {
    if (isSource(entry.path()))
    {
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
      {
        const bool comment = line.find_first_of("/*") < line.find("vtkSMPTools");
        if (!comment && line.find("vtkSMPTools::For(") != std::string::npos)
        {
          ++loops;
          EXPECT_EQ(entry.path().filename(), "ParallelFor.cxx") << entry.path();
        }
      }
    }
  }
  EXPECT_EQ(loops, 1);
}

TEST(Layering, OneThatGoesUpIsFound)
{
  const std::map<std::string, int> floors = readFloors();
  EXPECT_NE(complaint({ "Mesh/TetMesh.h", 1, "Light/Lighting.h" }, floors), "");
  EXPECT_NE(complaint({ "Optics/BinAreas.h", 1, "Caching/Fingerprint.h" }, floors), "");
  EXPECT_NE(complaint({ "GL/Pipeline.h", 1, "vtkTetMarchVolumeMapper.h" }, floors), "");
  EXPECT_NE(complaint({ "Light/Lighting.h", 1, "vtkOpenGLRenderWindow.h" }, floors), "");
  EXPECT_NE(complaint({ "Mesh/TetMeshBuilder.h", 1, "TetMesh.h" }, floors), "");
  EXPECT_EQ(complaint({ "Blocks/BlockList.h", 1, "Mesh/TetMesh.h" }, floors), "");
  EXPECT_EQ(complaint({ "GL/Pipeline.h", 1, "vtkOpenGLRenderWindow.h" }, floors), "");
  EXPECT_EQ(complaint({ "Mapper/FrameOptions.h", 1, "vtkTetMarchSettings.h" }, floors), "");
  EXPECT_EQ(complaint({ "Mesh/TetMesh.h", 1, "vtkType.h" }, floors), "");
}
} // namespace
