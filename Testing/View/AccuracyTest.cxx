// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AccuracyPanel.h"
#include "ErrorTimePlot.h"
#include "Programs.h"
#include "ValueSlider.h"
#include "ViewCase.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"

#include <QComboBox>
#include <QSlider>
#include <QtTest>

namespace
{
using Statistics = vtkTetMarchFrameStatistics;
}

namespace tetmarch
{

/// The panel of accuracy and time: its settings, its figures and its plot.
class AccuracyTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void TheToleranceChangesTheStatistics();
  void EachSettingIsAPointOfThePlot();
  void TheGroundTruthTellsTheTrueError();
  void ABudgetIsKept();
};
TETMARCH_ADD_SUITE(AccuracyTest);

void AccuracyTest::TheToleranceChangesTheStatistics()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QSignalSpy measured(&this->GetModel(), &Model::Measured);
  auto* tolerance = this->Window->findChild<ValueSlider*>(QStringLiteral("tolerance"));
  auto* slider = tolerance->findChild<QSlider*>();
  QTest::keyClick(slider, Qt::Key_End);
  QVERIFY(Reaches(
    [&]
    {
      return measured.count() > 0 && statistics->GetUsedErrorTolerance() > 0.09 &&
             statistics->GetNumberOfPixels(Statistics::LOOKUPS) > 0;
    }));
  const double coarse = statistics->GetMean(Statistics::LOOKUPS);
  const double coarseBound = statistics->GetMaximum(Statistics::ERROR_BOUND);
  measured.clear();
  QTest::keyClick(slider, Qt::Key_Home);
  QVERIFY(Reaches([&] { return measured.count() > 0; }));
  QCOMPARE(statistics->GetUsedErrorTolerance(), 1e-5);
  QVERIFY(statistics->GetMean(Statistics::LOOKUPS) > coarse);
  // What is left is that of the steps of the tables' integrals.
  QVERIFY(statistics->GetMaximum(Statistics::ERROR_BOUND) < 0.1 * coarseBound);
}

void AccuracyTest::EachSettingIsAPointOfThePlot()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  ErrorTimePlot* plot = this->Window->GetAccuracy()->GetPlot();
  QVERIFY(Reaches([&] { return plot->GetPoints().size() == 1; }));
  auto* level = this->Window->findChild<QComboBox*>(QStringLiteral("level"));
  QTest::keyClick(level, Qt::Key_Down); // accurate
  QVERIFY(Reaches([&] { return plot->GetPoints().size() == 2; }));
  QVERIFY(plot->GetPoints()[1].Error < plot->GetPoints()[0].Error);
  QVERIFY(plot->GetPoints()[1].Error <= 2.0 / 4096.0); // and the steps of the tables' integrals
}

void AccuracyTest::TheGroundTruthTellsTheTrueError()
{
  this->OpenPicture(GetData("golfball_small.vtu"));
  this->Window->resize(240, 200); // each pixel takes long
  this->Wait();
  QVERIFY(this->GetModel().CompareWithGroundTruth());
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QVERIFY(statistics->GetNumberOfPixels(Statistics::TRUE_ERROR) > 1000);
  QVERIFY(statistics->GetMaximum(Statistics::TRUE_ERROR) > 0.0);
  QVERIFY(statistics->GetMaximum(Statistics::TRUE_ERROR) <= 1.0 / 255.0);
}

void AccuracyTest::ABudgetIsKept()
{
  this->OpenLattice();
  QSignalSpy frames(&this->GetModel(), &Model::Rendered);
  this->GetModel().Edit([](ViewState& s) { s.Settings.FrameTimeBudget = 1e-6; });
  QVERIFY(Reaches([&] { return frames.count() > 3; })); // by themselves
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QCOMPARE(statistics->GetUsedAccuracyLevel(), int(vtkTetMarchSettings::FAST));
}

} // namespace tetmarch

#include "AccuracyTest.moc"
