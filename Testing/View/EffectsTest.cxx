// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Effect.h"
#include "EffectTimer.h"
#include "EffectsPanel.h"
#include "Programs.h"
#include "ViewCase.h"

#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <QCheckBox>
#include <QLabel>
#include <QtTest>

#include <cmath>

namespace tetmarch
{

/// The panel of effects of light.
class EffectsTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void EachEffectChangesThePicture();
  void TheCostOfAnEffectIsMeasured();
};
TETMARCH_ADD_SUITE(EffectsTest);

void EffectsTest::EachEffectChangesThePicture()
{
  this->OpenLattice();
  EffectsPanel* panel = this->Window->GetEffects();
  const Pixels plain = this->Draw();
  for (int i = 0; i < static_cast<int>(GetEffects().size()); ++i)
  {
    const char* name = GetEffects()[i].Name;
    QTest::keyClick(panel->GetCheck(i), Qt::Key_Space);
    panel->GetTimer()->Stop();
    QVERIFY2(panel->GetCheck(i)->isChecked(), name);
    const Difference change = Compare(plain, this->Draw());
    QVERIFY2(change.Bytes > 1000 && change.Most > 5, name);
    QTest::keyClick(panel->GetCheck(i), Qt::Key_Space);
    if (panel->GetCheck(0)->isChecked()) // shading, which light needs
    {
      QTest::keyClick(panel->GetCheck(0), Qt::Key_Space);
    }
    const Difference back = Compare(plain, this->Draw());
    QVERIFY2(back.Bytes == 0, qPrintable(QString::fromLatin1(name) + QString::number(back.Most)));
  }
}

void EffectsTest::TheCostOfAnEffectIsMeasured()
{
  this->OpenLattice();
  const Pixels plain = this->Draw();
  EffectsPanel* panel = this->Window->GetEffects();
  const QSignalSpy measured(panel->GetTimer(), &EffectTimer::Measured);
  std::vector<bool> lit;
  connect(&this->GetModel(), &Model::Rendered, this,
    [&]
    {
      vtkVolume* volume = this->GetModel().GetScene().GetVolume();
      lit.push_back(volume->GetProperty()->GetShade() != 0);
    });
  panel->GetTimer()->Measure(0);
  QVERIFY(Reaches([&] { return measured.count() == 1; }));
  QVERIFY(!panel->GetTimer()->IsBusy());
  // Three turns, each of two frames without it, the first with it, and another one.
  std::vector<bool> turns;
  for (int turn = 0; turn < 3; ++turn)
  {
    turns.insert(turns.end(), { false, false, true, true });
  }
  QCOMPARE(lit, turns);
  const double added = measured[0][1].toDouble();
  QVERIFY(std::isfinite(added));
  QVERIFY(measured[0][2].toDouble() >= 0.0); // once
  // Less than nothing if other programs slowed down the frames without it.
  QVERIFY(panel->GetCost(0)->text().contains(QString::number(std::abs(added), 'f', 3)));
  // The picture is what it was, without the effect.
  QCOMPARE(Compare(plain, this->Draw()).Bytes, std::size_t(0));
}

} // namespace tetmarch

#include "EffectsTest.moc"
