// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"
#include "ViewCase.h"
#include "WriteGrids.h"

#include <QComboBox>
#include <QtTest>

namespace tetmarch
{

/// What of the data is drawn: blend modes, views and cuts.
class ModesTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void EachChoiceIsDrawn_data();
  void EachChoiceIsDrawn();
  void CutsTakeSomethingAway();
};
TETMARCH_ADD_SUITE(ModesTest);

void ModesTest::EachChoiceIsDrawn_data()
{
  QTest::addColumn<QString>("name");
  QTest::newRow("blend modes") << QStringLiteral("blend");
  QTest::newRow("views") << QStringLiteral("view");
  QTest::newRow("curved cells") << QStringLiteral("curved");
}

void ModesTest::EachChoiceIsDrawn()
{
  QFETCH(QString, name);
  this->OpenPicture(WriteCurvedCells(this->Folder.filePath(QStringLiteral("curved.vtu"))));
  auto* choice = this->Window->findChild<QComboBox*>(name);
  const Pixels plain = this->Draw();
  for (int i = 1; i < choice->count(); ++i)
  {
    QTest::keyClick(choice, Qt::Key_Down);
    this->Wait();
    QCOMPARE(choice->currentIndex(), i);
    const Pixels drawn = this->Draw();
    QVERIFY(Compare(plain, drawn).Bytes > 1000);
    QVERIFY(CountDrawn(drawn) > 1000);
  }
  QTest::keyClick(choice, Qt::Key_Home);
  this->Wait();
  QCOMPARE(Compare(plain, this->Draw()).Bytes, std::size_t(0));
}

void ModesTest::CutsTakeSomethingAway()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  const std::size_t whole = CountDrawn(this->Draw());
  for (const bool crop : { false, true })
  {
    this->GetModel().Edit(
      [&](ViewState& s)
      {
        s.Cuts.Clip = !crop;
        s.Cuts.Crop = crop;
        if (crop) // the lower half
        {
          s.Cuts.Box[1] = (s.Cuts.Box[0] + s.Cuts.Box[1]) / 2.0;
        }
      });
    const QString path = this->Folder.filePath(QStringLiteral("cut.png"));
    QVERIFY(this->Window->SaveScreenshot(path)); // without handles
    const std::size_t left = CountDrawn(ReadPng(path));
    QVERIFY(left > 1000);
    QVERIFY2(left < whole * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(left).arg(whole)));
    // The handles are in the picture on the screen.
    this->Wait();
    QVERIFY(Compare(ReadPng(path), this->Draw()).Bytes > 500);
  }
}

} // namespace tetmarch

#include "ModesTest.moc"
