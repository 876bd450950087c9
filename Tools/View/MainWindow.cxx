// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include "AccuracyPanel.h"
#include "CutsPanel.h"
#include "DataPanel.h"
#include "EffectsPanel.h"
#include "FunctionDock.h"
#include "Messages.h"
#include "PictureWidget.h"
#include "TimeBar.h"
#include "TransferFunctionEditor.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int MessageMilliseconds = 15000;

/// A panel that is taller than its dock scrolls.
QScrollArea* MakeScrolling(QWidget* panel)
{
  auto* area = new QScrollArea;
  area->setWidget(panel);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumWidth(std::max(panel->minimumSizeHint().width() + 24, 370));
  return area;
}
} // namespace

namespace tetmarch
{

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
{
  this->setWindowTitle(QStringLiteral("TetMarch"));
  this->setAcceptDrops(true);
  this->resize(1260, 900);
  this->Picture = new PictureWidget(this->Shown);
  this->setCentralWidget(this->Picture);
  this->Hint = new QLabel(tr("Drop a file here, or choose File, Open"));
  this->Hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->Hint->setStyleSheet(QStringLiteral("color: #9aa4b4; font-size: 15pt;"));
  auto* overlay = new QVBoxLayout(this->Picture);
  overlay->addWidget(this->Hint, 0, Qt::AlignCenter);

  this->MakeDocks();
  this->MakeStatusBar();
  this->MakeFileMenu();
  this->MakeViewMenu();
  this->MakeHelpMenu();

  this->MakeHandles();
  connect(&this->Shown, &Model::Failed, this, &MainWindow::ShowFailure);
  connect(&this->Shown, &Model::LoadingChanged, this, &MainWindow::ShowLoading);
  connect(&this->Shown, &Model::DataChanged, this,
    [this]
    {
      this->Hint->hide();
      this->Handles->SetBounds(this->Shown.GetScene().GetBounds().data());
      this->LightBall->SetBounds(this->Shown.GetScene().GetBounds().data());
      this->setWindowTitle(
        tr("%1 – TetMarch").arg(QString::fromStdString(this->Shown.GetState().Data.File)));
    });
  connect(&this->Shown, &Model::StateChanged, this, &MainWindow::ShowHandles);
  const auto showHandles = [this]
  {
    this->ShowHandles();
    this->Shown.RequestRender();
  };
  connect(this->Cuts, &CutsPanel::HandlesChanged, this, showHandles);
  connect(this->Effects, &EffectsPanel::HandleChanged, this, showHandles);
  connect(&this->Shown, &Model::Rendered, this,
    [this]
    {
      const ViewState& state = this->Shown.GetState();
      this->FrameText->setText(tr("%1 s a frame, %2 × %3 pixels")
                                 .arg(this->Shown.GetLastSeconds(), 0, 'f', 3)
                                 .arg(state.Size[0])
                                 .arg(state.Size[1]));
    });
  connect(this->Picture, &PictureWidget::Clicked, this, &MainWindow::ShowPick);
  connect(&this->Shown.GetLoader(), &Loader::Progressed, this, &MainWindow::ShowProgress);
  connect(&this->Shown, &Model::DrawingProgressed, this, &MainWindow::ShowDrawing);
  // What VTK says, in whichever thread.
  SetMessageListener(
    [this](const std::string& kind, const std::string& text)
    {
      const QString line = QString::fromStdString(kind + ": " + text);
      QMetaObject::invokeMethod(
        this, [this, line] { this->statusBar()->showMessage(line, MessageMilliseconds); },
        Qt::QueuedConnection);
    });
}

MainWindow::~MainWindow()
{
  SetMessageListener({});
  this->hide(); // panels tell the model, which ends before them
  this->Handles.reset();
  this->LightBall.reset();
  delete this->Picture;
}

void MainWindow::MakeDocks()
{
  this->Data = new DataPanel(this->Shown);
  this->Accuracy = new AccuracyPanel(this->Shown);
  this->Effects = new EffectsPanel(this->Shown);
  this->Cuts = new CutsPanel(this->Shown);
  this->Panels = new QMenu(tr("&Panels"), this);
  const auto add =
    [this](const QString& title, const char* name, QWidget* panel, Qt::DockWidgetArea area)
  {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QString::fromLatin1(name));
    dock->setWidget(panel);
    this->addDockWidget(area, dock);
    this->Panels->addAction(dock->toggleViewAction());
    return dock;
  };
  this->Functions = MakeFunctionEditor(this->Shown);
  add(tr("Transfer functions"), "functions", this->Functions, Qt::BottomDockWidgetArea);
  const auto right = Qt::RightDockWidgetArea;
  add(tr("Data"), "data", MakeScrolling(this->Data), right);
  auto* accuracy = add(tr("Accuracy and time"), "accuracy", MakeScrolling(this->Accuracy), right);
  auto* effects = add(tr("Effects"), "effects", MakeScrolling(this->Effects), right);
  auto* cuts = add(tr("Cuts"), "cuts", MakeScrolling(this->Cuts), right);
  this->tabifyDockWidget(accuracy, effects);
  this->tabifyDockWidget(effects, cuts);
  accuracy->raise();
  this->setTabPosition(right, QTabWidget::North);
  this->setCorner(Qt::BottomRightCorner, right);
  this->Time = new TimeBar(this->Shown);
  this->addToolBar(Qt::BottomToolBarArea, this->Time);
}

void MainWindow::MakeStatusBar()
{
  this->PickText = new QLabel;
  this->PickText->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->PickText->setObjectName(QStringLiteral("pick"));
  this->Progress = new QProgressBar;
  this->Progress->setMaximumWidth(220);
  this->Cancel = new QPushButton(tr("Cancel"));
  this->Cancel->setObjectName(QStringLiteral("cancel"));
  this->FrameText = new QLabel;
  this->statusBar()->addWidget(this->PickText, 1);
  this->statusBar()->addPermanentWidget(this->Progress);
  this->statusBar()->addPermanentWidget(this->Cancel);
  this->statusBar()->addPermanentWidget(this->FrameText);
  this->Progress->hide();
  this->Cancel->hide();
  connect(this->Cancel, &QPushButton::clicked, this,
    [this]
    {
      this->Shown.GetLoader().Cancel();
      this->Shown.CancelFrames();
      Q_EMIT this->Shown.LoadingChanged(false);
      this->statusBar()->showMessage(tr("Cancelled"), MessageMilliseconds);
    });
}

void MainWindow::ShowFailure(const QString& text)
{
  auto* box = new QMessageBox(QMessageBox::Warning, tr("TetMarch"), text, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->open(); // and go on
}

void MainWindow::ShowLoading(bool busy)
{
  this->Progress->setVisible(busy);
  this->Cancel->setVisible(busy);
  if (busy)
  {
    this->Progress->setValue(0);
  }
  else if (this->Shown.HasData() &&
           this->LastFile == QString::fromStdString(this->Shown.GetState().Data.File))
  {
    this->AddRecent(this->LastFile);
  }
}

void MainWindow::ShowProgress(const QString& stage, double fraction)
{
  this->Progress->setFormat(stage + QStringLiteral(" %p %"));
  this->Progress->setValue(static_cast<int>(100.0 * fraction));
}

// What is being read is told first.
void MainWindow::ShowDrawing(const QString& stage, double share)
{
  if (!this->Shown.GetLoader().IsBusy())
  {
    const bool busy = share <= 1.0;
    this->Progress->setVisible(busy);
    this->Cancel->setVisible(busy);
    this->ShowProgress(stage, std::min(share, 1.0));
  }
}

void MainWindow::ShowPick(int x, int y)
{
  if (!this->Shown.HasData())
  {
    return;
  }
  this->HideHandles();
  const auto hit = this->Shown.GetScene().GetMapper().Pick(
    this->Shown.GetScene().GetRenderer(), this->Shown.GetScene().GetVolume(), x, y);
  this->ShowHandles();
  QString text = tr("nothing opaque enough there");
  if (hit)
  {
    const auto& at = hit->Position;
    text = tr("cell %1%2, position %3 %4 %5, %6 %7")
             .arg(hit->Cell)
             .arg(hit->Block > 0 ? tr(" of block %1").arg(hit->Block) : QString())
             .arg(at[0], 0, 'g', 7)
             .arg(at[1], 0, 'g', 7)
             .arg(at[2], 0, 'g', 7)
             .arg(QString::fromStdString(this->Shown.GetState().Data.Array))
             .arg(hit->Scalar, 0, 'g', 7);
  }
  this->PickText->setText(text);
  this->statusBar()->clearMessage();
  this->Shown.RequestRender();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
  {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event)
{
  this->Open(event->mimeData()->urls().first().toLocalFile());
  event->acceptProposedAction();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  this->Shown.GetLoader().Cancel();
  QMainWindow::closeEvent(event);
}

} // namespace tetmarch
