// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCase.h"

#include "Messages.h"
#include "PictureWidget.h"
#include "WriteGrids.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMessageBox>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSettings>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace
{
constexpr int Patience = 300000; // milliseconds: on any machine something is wrong then

tetmarch::Pixels TakePixels(vtkImageData* image)
{
  tetmarch::Pixels pixels;
  int size[3];
  image->GetDimensions(size);
  pixels.Width = size[0];
  pixels.Height = size[1];
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  const auto count = static_cast<std::size_t>(colors->GetNumberOfTuples());
  pixels.Bytes.resize(3 * count);
  for (std::size_t i = 0; i < pixels.Bytes.size(); ++i)
  {
    pixels.Bytes[i] = static_cast<unsigned char>(
      colors->GetComponent(static_cast<vtkIdType>(i / 3), static_cast<int>(i % 3)));
  }
  return pixels;
}
} // namespace

namespace tetmarch
{

Difference Compare(const Pixels& a, const Pixels& b)
{
  Difference difference;
  if (a.Width != b.Width || a.Height != b.Height)
  {
    return { a.Bytes.size() + b.Bytes.size(), 255 };
  }
  for (std::size_t i = 0; i < a.Bytes.size(); ++i)
  {
    const int off = std::abs(int(a.Bytes[i]) - int(b.Bytes[i]));
    difference.Bytes += off > 0;
    difference.Most = std::max(difference.Most, off);
  }
  return difference;
}

std::size_t CountDrawn(const Pixels& pixels)
{
  constexpr int clearly = 16;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels.Bytes.size(); i += 3)
  {
    int most = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      most = std::max(most, std::abs(int(pixels.Bytes[i + k]) - int(pixels.Bytes[k])));
    }
    count += most > clearly;
  }
  return count;
}

Pixels ReadPng(const QString& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.toUtf8().constData());
  reader->Update();
  return TakePixels(reader->GetOutput());
}

QString ViewCase::GetData(const char* name)
{
  return QStringLiteral(TETMARCH_SOURCE "/Data/") + QString::fromLatin1(name);
}

void ViewCase::OpenWindow(const QString& path)
{
  this->Window = std::make_unique<MainWindow>();
  this->Window->resize(900, 700);
  this->Window->show();
  QVERIFY(QTest::qWaitForWindowExposed(this->Window.get(), Patience));
  this->OpenFirst(path);
}

void ViewCase::HidePanels(MainWindow& window)
{
  for (QDockWidget* dock : window.findChildren<QDockWidget*>())
  {
    dock->hide();
  }
  window.resize(480, 360);
}

void ViewCase::ShowEmptyWindow()
{
  this->Window = std::make_unique<MainWindow>();
  HidePanels(*this->Window);
  this->Window->show();
  QVERIFY(QTest::qWaitForWindowExposed(this->Window.get(), Patience));
}

void ViewCase::OpenPicture(const QString& path)
{
  this->ShowEmptyWindow();
  this->OpenFirst(path);
}

void ViewCase::OpenLattice()
{
  constexpr int cells = 12; // along an axis
  this->OpenPicture(WriteLattice(this->Folder.filePath(QStringLiteral("lattice.vtu")), cells));
}

void ViewCase::OpenFirst(const QString& path)
{
  this->Window->Open(path);
  this->Wait();
  QVERIFY(this->GetModel().HasData());
}

bool ViewCase::Reaches(const std::function<bool()>& condition)
{
  QTimer wakes; // for what other threads do
  wakes.start(5);
  QElapsedTimer timer;
  timer.start();
  QCoreApplication::processEvents();
  while (!condition() && timer.elapsed() < Patience)
  {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return condition();
}

void ViewCase::Wait()
{
  QVERIFY(Reaches([this]
    { return !this->GetModel().GetLoader().IsBusy() && !this->GetModel().HasFramesToDraw(); }));
  QCoreApplication::processEvents(); // the widget is painted
}

Pixels ViewCase::Draw()
{
  this->GetModel().RenderWhole();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->GetModel().GetWindow());
  image->ShouldRerenderOff();
  image->ReadFrontBufferOff();
  image->Update();
  return TakePixels(image->GetOutput());
}

QPoint ViewCase::FindPlace(const Vector3& point)
{
  vtkRenderer* renderer = this->GetModel().GetScene().GetRenderer();
  renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
  renderer->WorldToDisplay();
  const double* at = renderer->GetDisplayPoint();
  const double ratio = this->Window->devicePixelRatioF();
  const int top = this->GetModel().GetWindow()->GetSize()[1] - 1;
  return { int(at[0] / ratio), int((top - int(at[1])) / ratio) };
}

QString ViewCase::TakeMessage()
{
  auto* box = this->Window->findChild<QMessageBox*>();
  const QString text = box ? box->text() : QString();
  delete box;
  return text;
}

void ViewCase::initTestCase()
{
  QVERIFY(this->Folder.isValid());
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, this->Folder.path());
}

void ViewCase::init() { this->ErrorsBefore = Messages::GetNumberOfErrors(); }

void ViewCase::cleanup()
{
  if (this->Window)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->GetModel().GetWindow());
    window->MakeCurrent();
    QCOMPARE(QOpenGLContext::currentContext()->functions()->glGetError(), GLenum(GL_NO_ERROR));
    this->Window.reset();
  }
  QCOMPARE(Messages::GetNumberOfErrors(), this->ErrorsBefore);
}

} // namespace tetmarch
