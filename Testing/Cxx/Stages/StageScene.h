// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene that tells which of its stages have run, and whether its picture is right
 */
#ifndef tetmarch_testing_StageScene_h
#define tetmarch_testing_StageScene_h

#include "CpuReference.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace tetmarch::testing
{
/// The counters of the stages, to say by how much they grew.
struct Work
{
  vtkTypeInt64 Mesh = 0;
  vtkTypeInt64 Scalars = 0;
  vtkTypeInt64 Tables = 0;
  vtkTypeInt64 Bytes = 0;
};

inline Work workOf(const vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetMeshBuilds(), mapper->GetScalarsBuilds(), mapper->GetTablesBuilds(),
    mapper->GetUploadedBytes() };
}

class StageScene : public ::testing::Test
{
protected:
  StageScene() { this->Before = this->Shown.render(); }

  /// Renders, expects those stages to have run once and the others not, and the picture to be what
  /// the reference makes of the scene as it is now.
  void expectRuns(int mesh, int scalars, int tables)
  {
    const Work before = workOf(this->Shown.Mapper);
    const Image after = this->Shown.render();
    this->Done = workOf(this->Shown.Mapper);
    EXPECT_EQ(this->Done.Mesh - before.Mesh, mesh);
    EXPECT_EQ(this->Done.Scalars - before.Scalars, scalars);
    EXPECT_EQ(this->Done.Tables - before.Tables, tables);
    this->Done.Bytes -= before.Bytes;
    EXPECT_EQ(this->Done.Bytes > 0, mesh + scalars + tables > 0);
    this->Changed = compare(this->Before, after).Max;
    this->Before = after;
    const Mask inside = regionsOf(this->Shown).Inside;
    EXPECT_LE(compare(after, referenceOf(this->Shown).Picture, inside).Max, 2.0 / 255.0);
  }

  vtkDataArray* scalars() { return this->Shown.Data->GetPointData()->GetScalars(); }
  vtkTypeInt64 bytesOfTetrahedra() const
  {
    return 16 * vtkTypeInt64(this->Shown.Mapper->GetNumberOfTetrahedra());
  }

  Scene Shown{ jitteredLattice(8, 0.15, 1, sineField()), 96, 96 };
  Image Before;
  Work Done;
  double Changed = 0.0; // between the two pictures
};
} // namespace tetmarch::testing

#endif
