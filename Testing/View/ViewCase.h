// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A window of tetmarch-view as tests use it: real events, pictures as bytes, and no error at the
 * end.
 */
#ifndef tetmarch_ViewCase_h
#define tetmarch_ViewCase_h

#include "MainWindow.h"

#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <QObject>
#include <QString>
#include <QTemporaryDir>

#include <functional>
#include <memory>

namespace tetmarch
{

/// The bytes of a picture, three a pixel, rows from the bottom.
struct Pixels
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;
};

/// How many bytes differ, and by how much at most; all of them if the sizes differ.
struct Difference
{
  std::size_t Bytes = 0;
  int Most = 0;
};
Difference Compare(const Pixels& a, const Pixels& b);

/// Pixels that are clearly not as the first one, which is background.
std::size_t CountDrawn(const Pixels& pixels);

Pixels ReadPng(const QString& path);

class ViewCase : public QObject
{
  Q_OBJECT

protected:
  /// Of the folder Data.
  static QString GetData(const char* name);

  /// A window with that file; it is shown and has drawn it.
  void OpenWindow(const QString& path);
  /// The same, small and without panels, which take time.
  void OpenPicture(const QString& path);
  /// The same of a small mesh, whose values are waves.
  void OpenLattice();
  /// A window like that, without a file.
  void ShowEmptyWindow();
  static void HidePanels(MainWindow& window);
  /// Handles events until the condition holds. Returns false if it didn't for very long.
  static bool Reaches(const std::function<bool()>& condition);
  /// Waits until nothing is read and nothing is to be drawn.
  void Wait();
  /// A frame at rest.
  Pixels Draw();
  /// Where the picture's widget shows a point of the world.
  QPoint FindPlace(const Vector3& point);
  /// The box with a message that is open; its text is returned, and it is closed.
  QString TakeMessage();
  Model& GetModel() { return this->Window->GetModel(); }

  QTemporaryDir Folder;
  std::unique_ptr<MainWindow> Window;

private Q_SLOTS:
  void initTestCase();
  void init();
  /// No error of VTK or of the GL.
  void cleanup();

private:
  void OpenFirst(const QString& path);

  int ErrorsBefore = 0;
};

} // namespace tetmarch

#endif
