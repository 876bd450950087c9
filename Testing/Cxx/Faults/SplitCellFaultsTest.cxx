// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra in two texture buffers: what is too large, what finds no room, and what is left
// behind.
#include "ErrorWatch.h"
#include "FaultyGL.h"
#include "GLObjects.h"
#include "Scene.h"

#include "vtkLogger.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 64;
constexpr int Tets = 6 * 12 * 12 * 12;

class SplitCellFaults : public testing::Test
{
protected:
  SplitCellFaults()
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // VTK itself complains of faults, too
    this->Shown.drawCellScalars();
    this->Sound = this->Shown.render();
    this->release();
    this->None = countGLObjects();
  }
  ~SplitCellFaults() override { vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO); }

  void release() { this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window); }

  void expectSound()
  {
    this->Watch.Errors.clear();
    EXPECT_EQ(compare(this->Shown.render(), this->Sound).Max, 0.0);
    EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
  }

  Scene Shown{ jitteredLattice(12, 0.15, 1, sineField()), Side, Side };
  ErrorWatch Watch{ this->Shown.Mapper };
  Image Sound;
  std::array<int, 5> None{};
};

TEST_F(SplitCellFaults, TooManyForTwo)
{
  for (int frame = 0; frame < 2; ++frame)
  {
    const FaultyGL few = FaultyGL::withMostTexels(Tets / 2 - 1);
    this->Shown.Window->Render();
    EXPECT_TRUE(few.happened());
  }
  ASSERT_EQ(this->Watch.Errors.size(), 1u);
  for (const std::string& word : { "needs " + std::to_string(Tets) + " texels for its tetrahedra",
         "takes " + std::to_string(Tets - 2) + " (2 x GL_MAX_TEXTURE_BUFFER_SIZE)" })
  {
    EXPECT_NE(this->Watch.Errors[0].find(word), std::string::npos) << this->Watch.Errors[0];
  }
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
  this->release();
  EXPECT_EQ(countGLObjects(), this->None);
  const FaultyGL enough = FaultyGL::withMostTexels(Tets / 2);
  this->expectSound();
}

// Cells, cell scalars and all else, one call after the other.
TEST_F(SplitCellFaults, NoRoomForOneOfTheBuffers)
{
  for (const Fault fault : { Fault::BufferData, Fault::TexBuffer })
  {
    this->release();
    int errors = 0;
    for (int call = 0; call < 100; ++call)
    {
      SCOPED_TRACE(std::string(nameOf(fault)) + ", call " + std::to_string(call));
      this->Watch.Errors.clear();
      bool met = false;
      {
        const FaultyGL faulty(Tets / 2, fault, call);
        this->Shown.Window->Render();
        met = faulty.happened();
      }
      if (!met)
      {
        break;
      }
      ASSERT_LE(this->Watch.Errors.size(), 1u);
      errors += static_cast<int>(this->Watch.Errors.size());
      this->release();
      EXPECT_EQ(countGLObjects(), this->None);
      const FaultyGL few = FaultyGL::withMostTexels(Tets / 2);
      this->expectSound();
      this->release();
    }
    EXPECT_GT(errors, 8) << nameOf(fault); // cells 2, cell scalars 2, boundary, vertices, tables 3
  }
}

// Meshes in one buffer and in two, by turns; units of textures are given back, too.
TEST_F(SplitCellFaults, LeaveNothingBehind)
{
  const FaultyGL few = FaultyGL::withMostTexels(Tets / 2);
  const Grid large = this->Shown.Data;
  const Grid small = jitteredLattice(9, 0.15, 1, sineField(1.5));
  this->Shown.Mapper->SetInputData(small);
  const Image other = this->Shown.render();
  const auto held = countGLObjects();
  const int units = unitsInUse(this->Shown.Window);
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetGPUMemoryBytes();
  EXPECT_GT(compare(other, this->Sound).Max, 0.05);
  for (int turn = 0; turn < 3; ++turn)
  {
    this->Shown.Mapper->SetInputData(large);
    this->expectSound();
    this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, Side / 2, Side / 2);
    EXPECT_EQ(countGLObjects()[0] - held[0], 2);
    EXPECT_EQ(unitsInUse(this->Shown.Window), units);
    this->Shown.Mapper->SetInputData(small);
    EXPECT_EQ(compare(this->Shown.render(), other).Max, 0.0);
    EXPECT_EQ(countGLObjects()[0], held[0]);
    EXPECT_EQ(unitsInUse(this->Shown.Window), units);
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), bytes);
  }
  this->release();
  EXPECT_EQ(countGLObjects(), this->None);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}
} // namespace
