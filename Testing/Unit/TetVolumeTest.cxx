// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages that make a volume of tetrahedra run when their own input changed, and versions tell
// what has to be uploaded again.
#include "Volume/TetVolume.h"

#include "UnitMeshes.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class TetVolumes : public ::testing::Test
{
protected:
  vtkDataArray* array() { return this->Data->GetPointData()->GetScalars(); }

  // So often in all after one more update.
  void expectRuns(int mesh, int scalars)
  {
    EXPECT_EQ(this->Volume.updateGeometry({ this->Data }, {}, {}), "");
    VolumeInput input{ this->Data };
    input.TakesCorners = this->TakesCorners;
    EXPECT_EQ(this->Volume.updateScalars(input, this->Drawn), "");
    EXPECT_EQ(this->Volume.meshRecord().Runs, mesh);
    EXPECT_EQ(this->Volume.scalarsRecord().Runs, scalars);
  }

  void hideFirstCell()
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(this->Data->GetNumberOfCells());
    ghosts->Fill(0);
    ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
    this->Data->GetCellData()->AddArray(ghosts);
  }

  Grid Data = jitteredLattice(3, 0.15, 1, sineField());
  DrawnScalars Drawn{ array() };
  bool TakesCorners = false;
  TetVolume Volume;
};

TEST_F(TetVolumes, AreMadeOnce)
{
  this->expectRuns(1, 1);
  this->expectRuns(1, 1);
  EXPECT_EQ(this->Volume.mesh().Tets.size(), built(this->Data).Tets.size());
  EXPECT_GT(this->Volume.scalars().Range.High, this->Volume.scalars().Range.Low);
}

TEST_F(TetVolumes, OtherScalarsLeaveTheMesh)
{
  this->expectRuns(1, 1);
  const Fingerprint links = this->Volume.linksVersion();
  const Fingerprint scalars = this->Volume.scalarsVersion();
  this->array()->Modified();
  this->expectRuns(1, 2);
  EXPECT_EQ(this->Volume.linksVersion(), links);
  EXPECT_NE(this->Volume.scalarsVersion(), scalars);
  EXPECT_EQ(this->Volume.scalarsVersion().front(), scalars.front());
  this->Drawn = { this->Data->GetCellData()->GetScalars(), true };
  this->expectRuns(1, 3);
  EXPECT_EQ(this->Volume.scalars().OfCells.size(), this->Volume.mesh().Tets.size());
  EXPECT_FALSE(this->Volume.hasCellGradients());
}

// Points that coincide are one vertex. If their scalars differ by more than rounding, these are
// kept for each corner, or the points get vertices of their own.
TEST_F(TetVolumes, ScalarsThatJumpHaveCornersOrVerticesOfTheirOwn)
{
  const Id shared = static_cast<Id>(this->Data->GetNumberOfPoints());
  this->Data = withRepeatedPoints(this->Data);
  const Id repeated = static_cast<Id>(this->Data->GetNumberOfPoints());
  this->Drawn = { this->array() };
  this->expectRuns(1, 1);
  EXPECT_EQ(this->Volume.mesh().Vertices.size(), shared);
  const double value = this->array()->GetComponent(7, 0);
  this->array()->SetComponent(7, 0, value + 0.1);
  this->array()->Modified();
  this->TakesCorners = true;
  this->expectRuns(1, 2);
  EXPECT_EQ(this->Volume.mesh().Vertices.size(), shared);
  EXPECT_EQ(this->Volume.scalars().OfCorners.size(), this->Volume.mesh().Tets.size());
  this->TakesCorners = false;
  this->expectRuns(2, 3);
  EXPECT_EQ(this->Volume.mesh().Vertices.size(), repeated);
  EXPECT_TRUE(this->Volume.scalars().OfCorners.empty());
  this->expectRuns(2, 3);
  this->Drawn = { this->Data->GetCellData()->GetScalars(), true };
  this->expectRuns(3, 5);
  EXPECT_EQ(this->Volume.mesh().Vertices.size(), shared);
  this->array()->SetComponent(7, 0, value * (1 + 1e-15));
  this->Drawn = { this->array() };
  this->expectRuns(3, 6);
  EXPECT_EQ(this->Volume.mesh().Vertices.size(), shared);
  EXPECT_TRUE(this->Volume.scalars().OfCorners.empty());
}

TEST_F(TetVolumes, AnotherMeshNeedsItsScalars)
{
  this->expectRuns(1, 1);
  const Fingerprint links = this->Volume.linksVersion();
  const Fingerprint scalars = this->Volume.scalarsVersion();
  this->Data = jitteredLattice(4, 0.15, 1, sineField());
  this->Drawn = { this->array() };
  this->expectRuns(2, 2);
  EXPECT_NE(this->Volume.linksVersion(), links);
  EXPECT_NE(this->Volume.scalarsVersion().front(), scalars.front());
  EXPECT_EQ(this->Volume.gradients(false, nullptr).size(), this->Volume.mesh().Vertices.size());
}

TEST_F(TetVolumes, TheHierarchyIsNewLinks)
{
  this->Data = jitteredLattice(3, 0.0);
  this->Drawn = { this->array() };
  this->expectRuns(1, 1);
  ASSERT_FALSE(this->Volume.mesh().hasHierarchy());
  const Fingerprint links = this->Volume.linksVersion();
  EXPECT_EQ(this->Volume.prepareEntrySearch(), "");
  EXPECT_TRUE(this->Volume.mesh().hasHierarchy());
  EXPECT_NE(this->Volume.linksVersion(), links);
  EXPECT_EQ(this->Volume.prepareEntrySearch(), "");
  this->expectRuns(1, 1);
}

TEST_F(TetVolumes, HiddenCellsHaveTheirOwnVersion)
{
  this->expectRuns(1, 1);
  EXPECT_TRUE(this->Volume.hiddenCells().empty());
  const Fingerprint hidden = this->Volume.hiddenVersion();
  const std::int64_t runs = this->Volume.runs();
  this->hideFirstCell();
  this->expectRuns(1, 1);
  EXPECT_FALSE(this->Volume.hiddenCells().empty());
  EXPECT_NE(this->Volume.hiddenVersion(), hidden);
  EXPECT_EQ(this->Volume.runs(), runs + 1);
}

TEST_F(TetVolumes, WithoutCellsThereIsNothing)
{
  this->expectRuns(1, 1);
  const Grid empty = Grid::New();
  EXPECT_EQ(this->Volume.updateGeometry({ empty }, {}, {}), "");
  EXPECT_TRUE(this->Volume.mesh().Tets.empty());
}

TEST_F(TetVolumes, WhatIsWrongIsSaid)
{
  ResourceLimits limits;
  limits.TexelsPerBuffer = 10;
  EXPECT_NE(
    this->Volume.updateGeometry({ this->Data }, limits, {}).find("too large"), std::string::npos);
  EXPECT_TRUE(this->Volume.mesh().Tets.empty());
  this->expectRuns(1, 1);
}
} // namespace
