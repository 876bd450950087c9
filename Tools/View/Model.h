// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of the view, the scene that is made of it, and when it is drawn. Panels change the
 * state by Edit(), and are told by signals what they show.
 */
#ifndef tetmarch_Model_h
#define tetmarch_Model_h

#include "FrameEvents.h"
#include "Loader.h"
#include "Scene.h"
#include "ViewState.h"

#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace tetmarch
{

class Model : public QObject
{
  Q_OBJECT

public:
  explicit Model(QObject* parent = nullptr);
  ~Model() override;

  /// The window that shows the scene; it is set once.
  void SetWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetWindow() { return this->Window; }

  /// As it is drawn, camera and size included.
  const ViewState& GetState();
  Scene& GetScene() { return this->Drawn; }
  bool HasData() const { return this->Drawn.HasData(); }
  Loader& GetLoader() { return this->Reading; }

  /// Change the state, and draw it.
  void Edit(const std::function<void(ViewState&)>& change);
  /// Somebody has changed the functions of the scene.
  void TakeFunctions();
  /// Between these two calls frames may be coarse, so that they follow.
  void BeginDrag();
  void EndDrag();
  bool IsDragging() const { return this->Drags > 0; }

  /// Read, and show when that has succeeded. What is shown stays until then.
  void Open(const QString& path);
  void OpenSurface(const QString& path);
  void OpenState(const ViewState& state);
  void ChooseArray(const std::string& name, int association, int component);
  void ChooseTimeStep(int step);
  /// Of curved cells.
  void ChooseGeometryTolerance(double tolerance);

  void ResetCamera();
  void LookAlong(int axis);
  void SwitchProjection();

  /// What tells of Qt's events during a frame; it is told which widget shows the picture.
  FrameEvents& GetEvents() { return this->Events; }

  // Long frames at rest tell of their progress, and handle events. Whatever the user does stops
  // them, unless all of the frame is wanted.

  /// Draw now, at rest. Returns the seconds that it took.
  double Render();
  /// The same; what the user does waits until the frame is complete.
  void RenderWhole();
  /// Does what draws frames; what the user does waits until they are complete.
  void DrawWhole(const std::function<void()>& draw);
  /// Whether the last frame was stopped. The picture is still that of the frame before.
  bool WasStopped() const { return this->Stopped; }
  bool IsDrawing() const { return this->Drawing; }
  /// Whether a frame is being drawn, or comes soon.
  bool HasFramesToDraw() const
  {
    return this->Drawing || this->RenderSoon.isActive() || this->SettleSoon.isActive();
  }
  /// Stop, and draw no more until something changes.
  void CancelFrames();
  /// Draw soon.
  void RequestRender();
  /// Draw at rest, some time after the last coarse frame.
  void Settle();
  double GetLastSeconds() const { return this->LastSeconds; }

  /// Draw a frame that counts what its pixels cost; the picture stays.
  void Measure();
  /// Whether that is done by itself after each frame at rest.
  void SetMeasuring(bool measuring);
  /// Slow. Returns false if the frame could not be compared, or if the user has stopped it.
  bool CompareWithGroundTruth();

Q_SIGNALS:
  void StateChanged();
  void DataChanged();
  /// After each frame.
  void Rendered();
  /// The statistics have the counts of the pixels.
  void Measured();
  void Failed(const QString& text);
  void LoadingChanged(bool busy);
  /// Of a frame or a comparison that takes long; the share is above 1 when it has ended.
  void DrawingProgressed(const QString& stage, double share);

private:
  enum class Purpose
  {
    NewFile,
    Session,
    Array,
    TimeStep,
    Tolerance,
    Surface
  };

  void Start(Purpose purpose, const LoadJob& job);
  void Take(const std::shared_ptr<LoadResult>& result, const QString& failure);
  void Show(const LoadResult& result);
  double GetAspect() const;
  void NoteFrame(unsigned long event);
  void BeginFrame();
  void EndFrame();
  void FollowFrame();
  void TakeFrame();
  void EndWork();
  bool HandleEvents(const QString& stage);
  /// Whether a frame is being drawn: it is stopped then, and what is to be done is done later.
  bool WaitsForFrame(const std::function<void()>& later);
  bool IsAtRest() const;

  ViewState State;
  Scene Drawn;
  Loader Reading;
  vtkSmartPointer<vtkRenderWindow> Window;
  unsigned long Observers[3] = { 0, 0, 0 };
  FrameEvents Events;
  std::vector<std::function<void()>> AfterFrame;
  bool Drawing = false;
  bool Whole = false; // the frame isn't stopped
  bool Stopping = false;
  bool Stopped = false; // the last frame
  bool Told = false;    // of its progress
  QTimer RenderSoon;
  QTimer SettleSoon;
  QTimer MeasureSoon;
  int Drags = 0;
  bool Measuring = false;
  bool InMeasure = false;
  double FrameBegin = 0.0;
  double LastSeconds = 0.0;
  int FramesOfBudget = 0;
  Purpose Why = Purpose::NewFile;
  LoadJob Job;
  ViewState Wanted; // of a session
};

} // namespace tetmarch

#endif
