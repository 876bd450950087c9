// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"
#include "ViewCase.h"

#include "vtkTetMarchSettings.h"

#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QtTest>

namespace
{
QByteArray ReadFile(const QString& path)
{
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
} // namespace

namespace tetmarch
{

/// Web pages of what is shown.
class SavedPageTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void ThePictureStays_data();
  void ThePictureStays();
  void WhatItLacksIsTold();
  void AFileThatCannotBeWrittenIsTold();
};
TETMARCH_ADD_SUITE(SavedPageTest);

void SavedPageTest::ThePictureStays_data()
{
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("law");
  QTest::newRow("mesh") << "golfball_small.vtu"
                        << "unstructured";
  QTest::newRow("image") << "bonsai_small.vti"
                         << "structured";
}

void SavedPageTest::ThePictureStays()
{
  QFETCH(QString, file);
  QFETCH(QString, law);
  this->OpenPicture(GetData(file.toUtf8().constData()));
  const Pixels before = this->Draw();
  const QString path = this->Folder.filePath(law + ".html");
  QVERIFY(this->Window->SavePage(path));
  QCOMPARE(this->TakeMessage(), QString());
  const QString text = QString::fromUtf8(ReadFile(path));
  QVERIFY(
    text.contains(QStringLiteral("<title>%1: %2</title>")
                    .arg(file, QString::fromStdString(this->GetModel().GetState().Data.Array))));
  QVERIFY(text.contains(QStringLiteral("\"law\":\"%1\"").arg(law)));
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

void SavedPageTest::WhatItLacksIsTold()
{
  this->OpenLattice();
  this->GetModel().Edit(
    [](ViewState& s) { s.Settings.ViewMode = vtkTetMarchSettings::VIEW_ERROR_BOUND; });
  this->Wait();
  const QString path = this->Folder.filePath(QStringLiteral("bound.html"));
  QVERIFY(this->Window->SavePage(path));
  QCOMPARE(this->TakeMessage(),
    QStringLiteral("Saved %1. The view mode of a volume is not in the page: it shows the picture.")
      .arg(path));
}

void SavedPageTest::AFileThatCannotBeWrittenIsTold()
{
  this->OpenLattice();
  const QString path = this->Folder.filePath(QStringLiteral("none/page.html"));
  QVERIFY(!this->Window->SavePage(path));
  QCOMPARE(this->TakeMessage(), QStringLiteral("cannot write '%1': there is no folder '%2'")
                                  .arg(path, this->Folder.filePath(QStringLiteral("none"))));
}

} // namespace tetmarch

#include "SavedPageTest.moc"
