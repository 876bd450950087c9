// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the window reads and writes: data, sessions, pictures, scripts.
#include "MainWindow.h"

#include "EffectTimer.h"
#include "EffectsPanel.h"
#include "ErrorText.h"
#include "Failure.h"
#include "OutputFile.h"
#include "PngFile.h"
#include "PythonScript.h"
#include "RenderCommand.h"
#include "ViewStateJson.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkTetMarchWebExporter.h"
#include "vtkWindowToImageFilter.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>

namespace
{
constexpr int MostRecent = 8;
constexpr int MessageMilliseconds = 5000;
} // namespace

namespace tetmarch
{

void MainWindow::Open(const QString& path)
{
  const QFileInfo file(path);
  this->LastFile = file.absoluteFilePath();
  if (file.suffix().toLower() != QLatin1String("json"))
  {
    this->Shown.Open(this->LastFile);
    return;
  }
  try
  {
    this->Shown.OpenState(LoadSession(this->LastFile.toStdString()));
    this->AddRecent(this->LastFile);
  }
  catch (const Failure& failure)
  {
    this->ShowFailure(QString::fromStdString(failure.what()));
  }
}

void MainWindow::SaveSession(const QString& path)
{
  try
  {
    tetmarch::SaveSession(this->Shown.GetState(), path.toStdString());
    this->AddRecent(QFileInfo(path).absoluteFilePath());
    this->statusBar()->showMessage(tr("Saved %1").arg(path), MessageMilliseconds);
  }
  catch (const Failure& failure)
  {
    this->ShowFailure(QString::fromStdString(failure.what()));
  }
}

bool MainWindow::SaveScreenshot(const QString& path)
{
  this->Effects->GetTimer()->Stop();
  this->HideHandles();
  this->Shown.RenderWhole();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->Shown.GetWindow());
  image->ShouldRerenderOff();
  image->ReadFrontBufferOff();
  bool written = true;
  try
  {
    image->Update();
    WriteFile(QFile::encodeName(path).toStdString(), GetBytes(EncodePng(image->GetOutput())));
    this->statusBar()->showMessage(tr("Saved %1").arg(path), MessageMilliseconds);
  }
  catch (const Failure& failure)
  {
    written = false;
    this->ShowFailure(QString::fromStdString(failure.what()));
  }
  this->ShowHandles();
  this->Shown.RequestRender();
  return written;
}

bool MainWindow::SavePage(const QString& path)
{
  this->Effects->GetTimer()->Stop();
  this->HideHandles();
  const DataState& drawn = this->Shown.GetState().Data;
  const QString file = QFileInfo(QString::fromStdString(drawn.File)).fileName();
  vtkNew<vtkTetMarchWebExporter> page;
  page->SetRenderWindow(this->Shown.GetWindow());
  page->SetActiveRenderer(this->Shown.GetScene().GetRenderer());
  page->SetTitle((file.toStdString() + ": " + drawn.Array).c_str());
  const ErrorText error(page);
  std::string text;
  this->Shown.RenderWhole();
  this->Shown.DrawWhole([&] { text = page->WriteToString(); });
  this->ShowHandles();
  this->Shown.RequestRender();
  try
  {
    if (text.empty())
    {
      throw Failure("no page: " + error.Get());
    }
    WriteFile(QFile::encodeName(path).toStdString(), text);
  }
  catch (const Failure& failure)
  {
    this->ShowFailure(QString::fromStdString(failure.what()));
    return false;
  }
  this->statusBar()->showMessage(tr("Saved %1").arg(path), MessageMilliseconds);
  const QString lacks = QString::fromStdString(page->GetOmissions());
  if (!lacks.isEmpty())
  {
    this->ShowFailure(tr("Saved %1. %2").arg(path, lacks));
  }
  return true;
}

QString MainWindow::GetPythonScript()
{
  const bool structured = this->Shown.HasData() && this->Shown.GetScene().GetData().Data.Structured;
  return QString::fromStdString(WriteScript(this->Shown.GetState(), structured));
}

QString MainWindow::GetCommandLine()
{
  return QString::fromStdString(WriteCommand(this->Shown.GetState(), "picture.png"));
}

void MainWindow::AskForFile()
{
  const QString path = QFileDialog::getOpenFileName(this, tr("Open data or a session"), {},
    tr("Data and sessions (*.vtu *.vti *.vtr *.vts *.pvtu *.pvti *.vtm *.vtpc *.vthb *.htg *.pvd "
       "*.series *.vtk *.ex2 *.e *.exo *.g *.cgns *.p3d *.mhd *.mha *.nrrd *.nhdr *.raw "
       "*.json);;All files (*)"));
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void MainWindow::AskForSurface()
{
  const QString path = QFileDialog::getOpenFileName(
    this, tr("Open an opaque surface"), {}, tr("Surfaces (*.vtp *.pvtp *.vtk);;All files (*)"));
  if (!path.isEmpty())
  {
    this->Shown.OpenSurface(path);
  }
}

void MainWindow::AskForSession()
{
  const QString path = QFileDialog::getSaveFileName(
    this, tr("Save the session"), QStringLiteral("session.json"), tr("Sessions (*.json)"));
  if (!path.isEmpty())
  {
    this->SaveSession(path.endsWith(QLatin1String(".json")) ? path : path + ".json");
  }
}

void MainWindow::AskForScreenshot()
{
  const QString path = QFileDialog::getSaveFileName(
    this, tr("Save the picture"), QStringLiteral("picture.png"), tr("Pictures (*.png)"));
  if (!path.isEmpty())
  {
    this->SaveScreenshot(path.endsWith(QLatin1String(".png")) ? path : path + ".png");
  }
}

void MainWindow::AskForPage()
{
  const QString path = QFileDialog::getSaveFileName(
    this, tr("Save as web page"), QStringLiteral("scene.html"), tr("Web pages (*.html *.htm)"));
  if (!path.isEmpty())
  {
    const bool named =
      path.endsWith(QLatin1String(".html")) || path.endsWith(QLatin1String(".htm"));
    this->SavePage(named ? path : path + ".html");
  }
}

void MainWindow::AddRecent(const QString& path)
{
  QSettings settings;
  QStringList recent = settings.value(QStringLiteral("recent")).toStringList();
  recent.removeAll(path);
  recent.prepend(path);
  settings.setValue(QStringLiteral("recent"), QStringList(recent.mid(0, MostRecent)));
}

void MainWindow::ShowRecent()
{
  this->Recent->clear();
  const QStringList recent = QSettings().value(QStringLiteral("recent")).toStringList();
  for (const QString& path : recent)
  {
    this->Recent->addAction(path, this, [this, path] { this->Open(path); });
  }
  if (recent.isEmpty())
  {
    this->Recent->addAction(tr("None yet"))->setEnabled(false);
  }
}

} // namespace tetmarch
