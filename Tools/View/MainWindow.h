// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The window of tetmarch-view: picture, panels, menus.
 */
#ifndef tetmarch_MainWindow_h
#define tetmarch_MainWindow_h

#include "CutWidgets.h"
#include "LightHandle.h"
#include "Model.h"

#include <QMainWindow>

#include <memory>

class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QTimer;

namespace tetmarch
{
class AccuracyPanel;
class CutsPanel;
class DataPanel;
class EffectsPanel;
class PictureWidget;
class TimeBar;
class TransferFunctionEditor;

class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Data, or a session.
  void Open(const QString& path);
  void SaveSession(const QString& path);
  /// The picture as a PNG file, without handles of cuts. Returns whether that was done.
  bool SaveScreenshot(const QString& path);
  /// The scene as a web page, and tells what of it is not in there. Returns whether that was done.
  bool SavePage(const QString& path);
  /// What draws the same picture, as text.
  QString GetPythonScript();
  QString GetCommandLine();

  Model& GetModel() { return this->Shown; }
  PictureWidget* GetPicture() { return this->Picture; }
  AccuracyPanel* GetAccuracy() { return this->Accuracy; }
  EffectsPanel* GetEffects() { return this->Effects; }
  TimeBar* GetTimeBar() { return this->Time; }
  TransferFunctionEditor* GetFunctions() { return this->Functions; }

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void MakeDocks();
  void MakeHandles();
  void MakeStatusBar();
  void MakeFileMenu();
  void MakeViewMenu();
  void MakeHelpMenu();
  void AskForFile();
  void AskForSurface();
  void AskForSession();
  void AskForScreenshot();
  void AskForPage();
  void ShowRecent();
  void AddRecent(const QString& path);
  void ShowFailure(const QString& text);
  void ShowLoading(bool busy);
  void ShowProgress(const QString& stage, double fraction);
  void ShowDrawing(const QString& stage, double share);
  void ShowPick(int x, int y);
  void ShowHandles();
  void HideHandles();

  Model Shown;
  PictureWidget* Picture;
  QLabel* Hint;
  TransferFunctionEditor* Functions;
  DataPanel* Data;
  AccuracyPanel* Accuracy;
  EffectsPanel* Effects;
  CutsPanel* Cuts;
  TimeBar* Time;
  QLabel* FrameText;
  QLabel* PickText;
  QProgressBar* Progress;
  QPushButton* Cancel;
  QMenu* Recent = nullptr;
  QMenu* Panels = nullptr;
  QString LastFile; // that was asked for
  std::unique_ptr<CutWidgets> Handles;
  std::unique_ptr<LightHandle> LightBall;
};

} // namespace tetmarch

#endif
