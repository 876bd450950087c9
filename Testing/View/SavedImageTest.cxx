// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"
#include "SavedCase.h"

#include "vtkTetMarchSettings.h"

#include <QFile>
#include <QtTest>

namespace
{
using namespace tetmarch;

void DoNothing(ViewState&) {}

void TakeSamples(ViewState& s) { s.Settings.AccuracyLevel = vtkTetMarchSettings::SAMPLED; }

void ShowVoxels(ViewState& s) { s.Data.Nearest = true; }
} // namespace

namespace tetmarch
{

/// Pictures of images, saved and drawn again.
class SavedImageTest : public SavedCase
{
  Q_OBJECT

private Q_SLOTS:
  void AView_data();
  void AView();
  void OddNamesAreQuoted();
};
TETMARCH_ADD_SUITE(SavedImageTest);

void SavedImageTest::AView_data()
{
  QTest::addColumn<Change>("change");
  QTest::newRow("first") << Change(DoNothing);
  QTest::newRow("light") << Change(AddLight);
  QTest::newRow("cuts") << Change(AddCuts);
  QTest::newRow("samples") << Change(TakeSamples);
  QTest::newRow("voxels") << Change(ShowVoxels);
}

void SavedImageTest::AView()
{
  QFETCH(Change, change);
  this->OpenPicture(GetData("bonsai_small.vti"));
  this->GetModel().Edit(change);
  this->Wait();
  this->CheckPicture();
}

void SavedImageTest::OddNamesAreQuoted()
{
  const QString path = this->Folder.filePath(QStringLiteral("it's a $HOME \\ \"tree\".vti"));
  QVERIFY(QFile::copy(GetData("bonsai_small.vti"), path));
  this->OpenPicture(path);
  this->CheckPicture();
}

} // namespace tetmarch

#include "SavedImageTest.moc"
