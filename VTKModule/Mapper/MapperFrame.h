// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// One frame of a mapper that has something to draw: the recipe that all our mappers share.
#ifndef TetMarchMapperMapperFrame_h
#define TetMarchMapperMapperFrame_h

#include "GL/PeelHooks.h"
#include "GL/Pipeline.h"
#include "Mapper/FrameOptions.h"
#include "Mapper/MapperOptions.h"

#include "vtkNew.h"

class vtkAbstractVolumeMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTimerLog;
class vtkVolume;

namespace tetmarch
{

struct MapperState;

/** An array of the data, and what is shown of it. */
struct DrawnData
{
  vtkDataSet* Data = nullptr;
  FoundScalars Scalars;
  VectorOptions Vector;
  BlendOptions Blend;
  ClippingOptions Cuts;
};

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
  MapperFrame(const MapperScene& scene, MapperState& state, const BlendOptions& blend);
  ~MapperFrame();
  MapperFrame(const MapperFrame&) = delete;
  MapperFrame& operator=(const MapperFrame&) = delete;

  /** All stages of a pipeline that has begun, up to the picture, or to what the selector reads:
   * cells by their origins. What is wrong is the pipeline's error(). */
  void draw(Pipeline& pipeline, const DrawnData& drawn, const CellOrigins& origins);

  /** What the frame took and counted goes to the state, and its seconds to timeToDraw. Nothing is
   * done after a selection. */
  void end(Pipeline& pipeline, double& timeToDraw);

private:
  bool prepare(Pipeline& pipeline, const DrawnData& drawn);
  bool select(Pipeline& pipeline, const CellOrigins& origins);
  void record(const Pipeline& pipeline, double seconds);

  MapperScene Scene;
  MapperState& State;
  Progress Report;
  PeelHooks Hooks;
  FrameOptions Options;
  bool Drawn = false; // to the end
  vtkNew<vtkTimerLog> Timer;
};

} // namespace tetmarch

#endif
