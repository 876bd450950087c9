// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// One frame of a mapper that has something to draw: the recipe that all our mappers share.
#ifndef TetMarchMapperMapperFrame_h
#define TetMarchMapperMapperFrame_h

#include "Budget/AccuracyController.h"
#include "GL/PeelHooks.h"
#include "GL/Pipeline.h"
#include "Mapper/FrameOptions.h"
#include "Mapper/MapperOptions.h"
#include "Mapper/PieceAgreement.h"

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTimerLog;
class vtkVolume;

namespace tetmarch
{

class CaptureScope;
class TetVolume;
struct MapperState;

/** Who draws, and where. */
struct MapperScene
{
  vtkAbstractVolumeMapper* Mapper = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkRenderer* Renderer = nullptr;
  vtkVolume* Volume = nullptr;
};

class MapperFrame
{
public:
  /** The state has begun a frame, or a selection if the renderer has a selector. */
  MapperFrame(const MapperScene& scene, MapperState& state, const BlendOptions& blend,
    const FrameConditions& conditions);
  ~MapperFrame();
  MapperFrame(const MapperFrame&) = delete;
  MapperFrame& operator=(const MapperFrame&) = delete;

  /** Whether it is drawn between translucent surfaces, in parts. */
  bool isPeeled() const { return this->Hooks.isPeeling(); }

  /** Between rays, in pixels. */
  double rayDistance() const { return this->Options.Draw.SampleDistance; }

  /** All stages but the last of a pipeline that has begun. Done: there is something to draw. */
  StageResult prepare(Pipeline& pipeline, const DrawnData& drawn);
  /**
   * The same of tetrahedra of which each process of a group has a piece: collective, stage by
   * stage. `found` is what is wrong with the data of this process; a process without cells has a
   * grid without cells. A failure of any process, and what is to be agreed on, stops all of them.
   */
  StageResult prepareDistributed(TetVolume& piece, Pipeline& pipeline, const DrawnData& drawn,
    const std::string& found, GroupState& group);
  /** The last stage: the picture, or what the selector reads: cells by their origins; or what a
   * page needs, if there is a CaptureScope. */
  StageResult draw(Pipeline& pipeline, const CellOrigins& origins);

  /** What the frame took and counted goes to the state, and its seconds to timeToDraw. Nothing is
   * done after a selection. */
  void end(double& timeToDraw);

private:
  FrameInput inputOf(const DrawnData& drawn) const;
  StageResult agreeOnFrame(const DrawnData& drawn, const std::string& found, GroupState& group);
  StageResult prepareScalars(
    TetVolume& piece, Pipeline& pipeline, FrameInput& input, GroupState& group);
  void noteDistributed(const Pipeline& pipeline, GroupState& group);
  StageResult capture(Pipeline& pipeline, CaptureScope& scope);
  StageResult select(Pipeline& pipeline, const CellOrigins& origins);
  std::string describeBadForGroup() const;
  FrameResult resultOf(double seconds) const;
  void record(double seconds);
  void noteVisibility(const std::string& why) { this->Reasons.push_back(why); }
  std::string describeNothingVisible() const;
  std::string describeWrongRays() const;

  MapperScene Scene;
  MapperState& State;
  Progress Report;
  PeelHooks Hooks;
  FrameOptions Options;
  std::string ArrayName;            // of what was prepared last
  std::vector<Pipeline*> Pipelines; // that have drawn, back to front
  bool Failed = false;              // one of them did not come to its end
  /** Of each pipeline that was prepared: why nothing of it is visible. Empty if something may be,
   * or if something is wrong. */
  std::vector<std::string> Reasons;
  vtkNew<vtkTimerLog> Timer;
};

} // namespace tetmarch

#endif
