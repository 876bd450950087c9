// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "HeldJob.h"
#include "Programs.h"
#include "ViewCase.h"
#include "WriteGrids.h"

#include "vtkTetMarchFrameStatistics.h"

#include <QComboBox>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <algorithm>

namespace
{
constexpr char Reading[] = "reading";
constexpr char Preparing[] = "preparing the mesh";
constexpr int Few = 5; // events, and reports of progress
} // namespace

namespace tetmarch
{

/// A file is read, and its mesh prepared, beside the window; that can be stopped at any stage.
class LoadingTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void AnotherFileTakesThePlaceOfOneThatIsRead();
  void TellsItsProgress();
  void HandlesEventsWhileItPrepares();
  void Stops_data();
  void Stops();
  void IsCancelled_data();
  void IsCancelled();
  void EndsWithItsWindow_data();
  void EndsWithItsWindow();
  void KeepsTheMeshOfTimeSteps();
  void CutsCurvedCells();

private:
  /// Rows of a stage, and the fraction of it above which the job is held.
  static void AddStages();
  static void AddStage(const char* stage, double above);
  /// Begins to read the golf ball, up to where that holds.
  void BeginReading(HeldJob& held);
};
TETMARCH_ADD_SUITE(LoadingTest);

void LoadingTest::AddStage(const char* stage, double above)
{
  QTest::newRow(qPrintable(QStringLiteral("%1 above %2").arg(QLatin1String(stage)).arg(above)))
    << QString::fromLatin1(stage) << above;
}

void LoadingTest::AddStages()
{
  QTest::addColumn<QString>("stage");
  QTest::addColumn<double>("above");
  AddStage(Reading, 0.3);
  AddStage(Preparing, 0.0);
}

void LoadingTest::BeginReading(HeldJob& held)
{
  this->Window->Open(GetData("golfball_small.vtu"));
  QVERIFY(Reaches([&] { return held.Holds(); }));
}

void LoadingTest::AnotherFileTakesThePlaceOfOneThatIsRead()
{
  this->OpenPicture(GetData("golfball_small.vtu"));
  const QSignalSpy shown(&this->GetModel(), &Model::DataChanged);
  this->Window->Open(GetData("golfball_small.vtu"));
  this->Window->Open(GetData("golfball_small.vtu"));
  this->Window->Open(GetData("bonsai_small.vti"));
  this->Wait();
  QCOMPARE(shown.count(), 1);
  QVERIFY(this->Window->windowTitle().contains(QLatin1String("bonsai_small.vti")));
  QVERIFY(CountDrawn(this->Draw()) > 1000);
}

void LoadingTest::TellsItsProgress()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  const QSignalSpy told(&this->GetModel().GetLoader(), &Loader::Progressed);
  this->Window->Open(GetData("golfball_small.vtu"));
  this->Wait();
  int between = 0;
  for (const auto& values : told)
  {
    const double fraction = values[1].toDouble();
    between += values[0].toString() == QLatin1String(Reading) && fraction > 0.0 && fraction < 1.0;
  }
  QVERIFY(between >= Few);
}

void LoadingTest::HandlesEventsWhileItPrepares()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  std::vector<double> told;
  connect(&this->GetModel().GetLoader(), &Loader::Progressed, this,
    [&](const QString& stage, double fraction)
    {
      if (stage == QLatin1String(Preparing))
      {
        told.push_back(fraction);
      }
    });
  std::int64_t builds = 0;
  connect(&this->GetModel(), &Model::DataChanged, this,
    [&] { builds = this->GetModel().GetScene().GetMapper().GetStatistics()->GetMeshBuilds(); });
  HeldJob held(this->GetModel().GetLoader(), Preparing, 0.0);
  this->BeginReading(held);
  QTimer timer;
  const QSignalSpy rounds(&timer, &QTimer::timeout);
  timer.start(0);
  QVERIFY(Reaches([&] { return rounds.count() >= Few && !told.empty() && told.back() > 0.0; }));
  QVERIFY(held.Holds() && told.back() < 1.0);
  held.LetGo();
  this->Wait();
  QVERIFY(told.size() >= Few && std::is_sorted(told.begin(), told.end()));
  QCOMPARE(builds, std::int64_t(1)); // before anything was drawn of it
  QVERIFY(CountDrawn(this->Draw()) > 1000);
  Model& model = this->GetModel();
  QCOMPARE(model.GetScene().GetMapper().GetStatistics()->GetMeshBuilds(), vtkTypeInt64(1));
}

void LoadingTest::Stops_data() { AddStages(); }

void LoadingTest::Stops()
{
  QFETCH(QString, stage);
  QFETCH(double, above);
  LoadJob job;
  job.Wanted.File = GetData("golfball_small.vtu").toStdString();
  std::string at;
  double last = -1.0;
  const auto report = [&](const std::string& reached, double fraction)
  {
    at = reached;
    last = fraction;
    return reached != stage.toStdString() || fraction <= above;
  };
  QVERIFY_EXCEPTION_THROWN(RunJob(job, report), Cancelled);
  QCOMPARE(QString::fromStdString(at), stage);
  QVERIFY(last > above && last <= 1.0);
}

void LoadingTest::IsCancelled_data() { AddStages(); }

void LoadingTest::IsCancelled()
{
  QFETCH(QString, stage);
  QFETCH(double, above);
  this->OpenPicture(GetData("bonsai_small.vti"));
  const Pixels before = this->Draw();
  const QSignalSpy shown(&this->GetModel(), &Model::DataChanged);
  HeldJob held(this->GetModel().GetLoader(), stage.toStdString(), above);
  this->BeginReading(held);
  auto* cancel = this->Window->findChild<QPushButton*>(QStringLiteral("cancel"));
  QVERIFY(cancel->isVisible());
  QTest::mouseClick(cancel, Qt::LeftButton);
  QVERIFY(!cancel->isVisible());
  QVERIFY(!this->GetModel().GetLoader().IsBusy());
  held.LetGo();
  QVERIFY(Reaches([this] { return !this->GetModel().GetLoader().IsStopping(); }));
  QCOMPARE(shown.count(), 0);
  QVERIFY(this->TakeMessage().isEmpty());
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

void LoadingTest::EndsWithItsWindow_data()
{
  AddStages();
  AddStage(Reading, -1.0); // as it begins
  AddStage("choosing what to show", -1.0);
  AddStage("counting values", -1.0);
}

void LoadingTest::EndsWithItsWindow()
{
  QFETCH(QString, stage);
  QFETCH(double, above);
  this->ShowEmptyWindow();
  HeldJob held(this->GetModel().GetLoader(), stage.toStdString(), above);
  this->BeginReading(held);
  this->Window->close();
  QVERIFY(!this->GetModel().GetLoader().IsBusy());
  held.LetGo();
  this->Window.reset();
}

void LoadingTest::KeepsTheMeshOfTimeSteps()
{
  this->OpenPicture(WriteSteps(this->Folder.filePath(QStringLiteral("steps.vtu"))));
  const AnyMapper* mapper = &this->GetModel().GetScene().GetMapper();
  this->GetModel().ChooseTimeStep(0);
  this->Wait();
  this->Draw();
  QCOMPARE(this->GetModel().GetState().Data.TimeStep, 0);
  QCOMPARE(&this->GetModel().GetScene().GetMapper(), mapper);
  this->Window->Open(GetData("golfball_small.vtu"));
  this->Wait();
  QVERIFY(&this->GetModel().GetScene().GetMapper() != mapper);
}

void LoadingTest::CutsCurvedCells()
{
  this->OpenPicture(WriteCurvedCells(this->Folder.filePath(QStringLiteral("curved.vtu"))));
  Model& model = this->GetModel();
  auto* choice = this->Window->findChild<QComboBox*>(QStringLiteral("curved"));
  HeldJob held(model.GetLoader(), Preparing, 0.0);
  QTest::keyClick(choice, Qt::Key_End);
  QVERIFY(Reaches([&] { return held.Holds(); }));
  QCOMPARE(choice->currentText(), QStringLiteral("Within 1/2000"));
  QTest::mouseClick(
    this->Window->findChild<QPushButton*>(QStringLiteral("cancel")), Qt::LeftButton);
  QCOMPARE(choice->currentIndex(), 0);
  held.LetGo();
  model.ChooseGeometryTolerance(0.007); // none of the list
  this->Wait();
  QCOMPARE(choice->currentText(), QStringLiteral("Within 0.007"));
  vtkTetMarchFrameStatistics* statistics = model.GetScene().GetMapper().GetStatistics();
  QVERIFY(statistics->GetNumberOfTetrahedra() > 1000);      // of 8 cells
  QCOMPARE(statistics->GetBlocksBuilds(), vtkTypeInt64(1)); // before anything was drawn of it
  QCOMPARE(statistics->GetMeshBuilds(), vtkTypeInt64(1));
  this->Window->Open(GetData("golfball_small.vtu"));
  this->Wait();
  QVERIFY(!choice->isEnabled());
  QCOMPARE(choice->currentIndex(), 0);
}

} // namespace tetmarch

#include "LoadingTest.moc"
