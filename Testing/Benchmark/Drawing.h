// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene drawn by one mapper into a window, frame by frame from another side each time
 */
#ifndef tetmarch_bench_Drawing_h
#define tetmarch_bench_Drawing_h

#include "Scene.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>

class vtkTetMarchVolumeMapper;

namespace tetmarch::bench
{
/// The GL of a window that was rendered, VTK, and their threads.
nlohmann::json describeEnvironment(vtkRenderWindow* window);

class Drawing
{
public:
  /// The context exists and the empty background is drawn, so that the first frame costs what the
  /// mapper costs. Throws Failure if no GL can be had.
  Drawing(Scene scene, std::string mapper, const std::array<int, 2>& size);

  /// The next view. Throws Failure if the mapper reported an error or the picture is empty.
  nlohmann::json drawFrame();

  /// Switches all effects but that one off, and draws two frames of a view: the first does what
  /// is done once, the second is the one whose time counts. One draw call each, lest a frame that
  /// takes just over MaxDrawTimeInSeconds pays for tiles on top. Throws as drawFrame().
  nlohmann::json drawEffect(const std::string& effect, int view);

  /// Of the frames so far, but for their time.
  nlohmann::json mapperFigures() const;
  nlohmann::json environment() const;
  /// See GLDescription.h.
  nlohmann::json gl() const;
  nlohmann::json driverProbes() const;

  /// The first view with that effect beside what the CPU computes: see Parity.h.
  nlohmann::json compareWithCpu(const std::string& effect);

  /// What the first view shows, in float, against the picture in a file: see Errors.h.
  nlohmann::json compareFirstView(const std::string& file);
  /// Write that file.
  nlohmann::json writeReference(const std::string& file);

private:
  /// Returns seconds to be added to what it took.
  double ensureVolume();
  /// All effects but that one are off then, and a frame is one draw call. Throws Failure if the
  /// mapper has no effects.
  vtkTetMarchVolumeMapper* setEffect(const std::string& effect);
  void setView(int frame);
  /// Seconds of the view that is set.
  double timeFrame();
  void failOnError() const;
  double coveredShare();
  vtkTetMarchVolumeMapper* ours() const;

  Scene Shown;
  std::string MapperName;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkVolume> Volume; // nullptr before the first frame
  vtkNew<vtkUnsignedCharArray> Background;
  std::array<double, 3> FirstPosition; // of the camera
  int Frames = 0;
  std::string Error; // what the mapper reported last
};
} // namespace tetmarch::bench

#endif
