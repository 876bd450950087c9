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
#include "vtkUnstructuredGridVolumeMapper.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>

namespace tetmarch::bench
{
class Drawing
{
public:
  /// The context exists and the empty background is drawn, so that the first frame costs what the
  /// mapper costs. Throws Failure if no GL can be had.
  Drawing(const Scene& scene, const std::string& mapper, const std::array<int, 2>& size);

  /// Throws Failure if the mapper reported an error or the picture is empty.
  nlohmann::json drawFrame();

  nlohmann::json mapperFigures() const;
  nlohmann::json environment() const;

private:
  double coveredShare();

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkUnstructuredGridVolumeMapper> Mapper;
  vtkNew<vtkUnsignedCharArray> Background;
  std::string Error; // what the mapper reported last
};
} // namespace tetmarch::bench

#endif
