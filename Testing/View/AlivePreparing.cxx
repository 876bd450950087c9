// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh is prepared beside the window.
#include "AliveTest.h"
#include "Failure.h"
#include "Rounds.h"
#include "WriteGrids.h"

#include "vtkTetMarchFrameStatistics.h"

#include <QPushButton>
#include <QtTest>

namespace
{
constexpr int Patience = 120000;
constexpr int Cells = 60; // along an axis of a lattice whose mesh takes a while
constexpr int Little = 5; // events that are handled at least during long work
} // namespace

namespace tetmarch
{

void AliveTest::PreparesBesideTheWindow()
{
  const QString path = WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells);
  this->OpenWindow(GetData("bonsai_small.vti"));
  const Rounds rounds;
  int first = -1;
  int reports = 0;
  connect(&this->GetModel().GetLoader(), &Loader::Progressed, this,
    [&](const QString& stage, double fraction)
    {
      if (stage == QLatin1String("preparing the mesh") && fraction > 0.0 && fraction < 1.0)
      {
        first = first < 0 ? rounds.Count : first;
        ++reports;
      }
    });
  int last = 0;
  std::int64_t builds = 0;
  connect(&this->GetModel(), &Model::DataChanged, this,
    [&]
    {
      last = rounds.Count;
      builds = this->GetModel().GetScene().GetMapper().GetStatistics()->GetMeshBuilds();
    });
  this->Window->Open(path);
  this->Wait();
  QVERIFY(reports >= Little);
  QVERIFY(last - first >= Little);
  QCOMPARE(builds, std::int64_t(1)); // before anything was drawn of it
  QVERIFY(CountDrawn(this->Draw()) > 1000);
  Model& model = this->GetModel();
  QCOMPARE(model.GetScene().GetMapper().GetStatistics()->GetMeshBuilds(), vtkTypeInt64(1));
}

void AliveTest::StopsPreparing()
{
  LoadJob job;
  job.Wanted.File = GetData("golfball_small.vtu").toStdString();
  double last = -1.0;
  const auto report = [&](const std::string& stage, double fraction)
  {
    const bool preparing = stage == "preparing the mesh";
    last = preparing ? fraction : last;
    return !preparing || fraction < 0.3;
  };
  QVERIFY_EXCEPTION_THROWN(RunJob(job, report), Cancelled);
  QVERIFY(last >= 0.3 && last < 1.0);
}

void AliveTest::CancelsPreparing()
{
  const QString path = WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells);
  this->OpenWindow(GetData("bonsai_small.vti"));
  this->GetModel().SetMeasuring(false); // nothing is drawn meanwhile
  const Pixels before = this->Draw();
  QSignalSpy shown(&this->GetModel(), &Model::DataChanged);
  bool cancelled = false;
  connect(&this->GetModel().GetLoader(), &Loader::Progressed, this,
    [&](const QString& stage, double fraction)
    {
      if (stage == QLatin1String("preparing the mesh") && fraction > 0.0 && !cancelled)
      {
        cancelled = true;
        QTest::mouseClick(this->FindCancel(), Qt::LeftButton);
      }
    });
  this->Window->Open(path);
  QTRY_VERIFY_WITH_TIMEOUT(cancelled, Patience);
  QTRY_VERIFY(!this->FindCancel()->isVisible());
  QVERIFY(!this->GetModel().GetLoader().IsBusy());
  QTest::qWait(1000);
  QCOMPARE(shown.count(), 0);
  QVERIFY(this->TakeMessage().isEmpty());
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

void AliveTest::ClosesWhileItPrepares()
{
  const QString path = WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells);
  this->OpenWindow(GetData("bonsai_small.vti"));
  this->GetModel().SetMeasuring(false); // nothing is drawn meanwhile
  this->Draw();
  bool preparing = false;
  connect(&this->GetModel().GetLoader(), &Loader::Progressed, this,
    [&](const QString& stage, double)
    { preparing = stage == QLatin1String("preparing the mesh"); });
  this->Window->Open(path);
  while (!preparing)
  {
    QVERIFY(this->GetModel().GetLoader().IsBusy());
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  this->Window->close();
  this->Window.reset();
}

void AliveTest::KeepsTheMeshOfTimeSteps()
{
  this->OpenWindow(WriteSteps(this->Folder.filePath(QStringLiteral("steps.vtu"))));
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

} // namespace tetmarch
