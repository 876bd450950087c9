// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh is prepared beside the window.
#include "AliveTest.h"
#include "Failure.h"
#include "HeldJob.h"
#include "WriteGrids.h"

#include "vtkTetMarchFrameStatistics.h"

#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <algorithm>

namespace
{
constexpr char Preparing[] = "preparing the mesh";
constexpr int Few = 5;
} // namespace

namespace tetmarch
{

void AliveTest::PreparesBesideTheWindow()
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
  this->Window->Open(GetData("golfball_small.vtu"));
  QVERIFY(Reaches([&] { return held.Holds(); }));
  // The window handles events, and is told how far the work is.
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

void AliveTest::StopsPreparing()
{
  LoadJob job;
  job.Wanted.File = GetData("golfball_small.vtu").toStdString();
  double last = -1.0;
  const auto report = [&](const std::string& stage, double fraction)
  {
    const bool preparing = stage == Preparing;
    last = preparing ? fraction : last;
    return !preparing || fraction < 0.3;
  };
  QVERIFY_EXCEPTION_THROWN(RunJob(job, report), Cancelled);
  QVERIFY(last >= 0.3 && last < 1.0);
}

void AliveTest::CancelsPreparing()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  this->GetModel().SetMeasuring(false); // nothing is drawn meanwhile
  const Pixels before = this->Draw();
  const QSignalSpy shown(&this->GetModel(), &Model::DataChanged);
  HeldJob held(this->GetModel().GetLoader(), Preparing, 0.0);
  this->Window->Open(GetData("golfball_small.vtu"));
  QVERIFY(Reaches([&] { return held.Holds(); }));
  QTest::mouseClick(this->FindCancel(), Qt::LeftButton);
  QVERIFY(!this->FindCancel()->isVisible());
  QVERIFY(!this->GetModel().GetLoader().IsBusy());
  held.LetGo();
  QVERIFY(Reaches([this] { return !this->GetModel().GetLoader().IsStopping(); }));
  QCOMPARE(shown.count(), 0);
  QVERIFY(this->TakeMessage().isEmpty());
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

void AliveTest::ClosesWhileItPrepares()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  HeldJob held(this->GetModel().GetLoader(), Preparing, 0.0);
  this->Window->Open(GetData("golfball_small.vtu"));
  QVERIFY(Reaches([&] { return held.Holds(); }));
  this->Window->close();
  held.LetGo();
  this->Window.reset();
}

void AliveTest::KeepsTheMeshOfTimeSteps()
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

} // namespace tetmarch
