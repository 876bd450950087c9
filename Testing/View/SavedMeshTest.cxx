// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"
#include "SavedCase.h"
#include "WriteGrids.h"
#include "WriteKinds.h"

#include "vtkTetMarchSettings.h"

#include <QtTest>

namespace
{
using namespace tetmarch;

void Turn(ViewState& s)
{
  s.Camera.Position = { { 1.0 / 3.0, -2.7, 1.4 } };
  s.Camera.ViewUp = { { 0.1, 0.2, 0.9 } };
  s.Camera.ViewAngle = 41.0;
  s.Settings.ErrorTolerance = 1e-4;
  s.Functions.UnitDistance /= 3.0;
  s.Functions.Color[0] = { { s.Functions.Color[0][0], 0.1, 1.0 / 3.0, 1.0, 0.5, 0.0 } };
}

void MakeSurfaces(ViewState& s)
{
  s.BlendMode = 5;
  s.Effects.Shading = true;
  s.Effects.Headlight = true;
}

void AddGradientOpacity(ViewState& s) { s.Effects.GradientOpacity = true; }
} // namespace

namespace tetmarch
{

/// Pictures of meshes, saved and drawn again.
class SavedMeshTest : public SavedCase
{
  Q_OBJECT

private Q_SLOTS:
  void TheFirstPicture();
  void LeavesOfATree();
  void CurvedCells();
  void AChangedView_data();
  void AChangedView();
};
TETMARCH_ADD_SUITE(SavedMeshTest);

void SavedMeshTest::TheFirstPicture()
{
  this->OpenPicture(GetData("golfball_small.vtu"));
  this->CheckPicture();
}

void SavedMeshTest::LeavesOfATree()
{
  this->OpenPicture(WriteTree(this->Folder.path()));
  this->CheckPicture();
}

void SavedMeshTest::CurvedCells()
{
  this->OpenPicture(WriteCurvedCells(this->Folder.filePath(QStringLiteral("curved.vtu"))));
  this->GetModel().ChooseGeometryTolerance(0.01);
  this->Wait();
  this->CheckPicture();
}

void SavedMeshTest::AChangedView_data()
{
  QTest::addColumn<Change>("change");
  QTest::newRow("turned") << Change(Turn);
  QTest::newRow("light") << Change(AddLight);
  QTest::newRow("cuts") << Change(AddCuts);
  QTest::newRow("cells") << Change(ShowCells);
  QTest::newRow("isosurfaces") << Change(MakeSurfaces);
  QTest::newRow("gradient opacity") << Change(AddGradientOpacity);
}

void SavedMeshTest::AChangedView()
{
  QFETCH(Change, change);
  this->OpenLattice();
  this->GetModel().Edit(change);
  this->Wait();
  this->CheckPicture();
}

} // namespace tetmarch

#include "SavedMeshTest.moc"
