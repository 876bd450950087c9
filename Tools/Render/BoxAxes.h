// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Three axes with coordinates, each along an edge of a box's silhouette. Nothing of the box lies
 * before or behind them, so they are drawn in two dimensions, with text as large along all of them,
 * and the same whether the picture is drawn in tiles or not.
 */
#ifndef tetmarch_BoxAxes_h
#define tetmarch_BoxAxes_h

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"

#include <array>
#include <string>
#include <vector>

class vtkCamera;
class vtkRenderer;

namespace tetmarch
{

class BoxAxes
{
public:
  /// The size is that of the picture, and scale says by how much lines and text are larger than in
  /// one of 1024 x 768.
  BoxAxes(const std::array<int, 2>& pictureSize, double scale, const std::array<double, 3>& color);

  void AddTo(vtkRenderer* renderer);

  /// Where they are, for a box and a camera, whose projection is that of the whole picture. Returns
  /// false, and hides them, if some of the box is behind the camera.
  bool Place(const std::array<double, 6>& bounds, vtkCamera* camera);

private:
  using Point = std::array<double, 2>; // in pixels of the picture

  struct Edge;
  struct Projection;

  void AddAxis(const Projection& projection, const Edge& edge);
  void AddLine(const Point& a, const Point& b);
  void AddText(const std::string& text, double fontSize, const Point& center);
  double GetReach(const std::string& text, double fontSize, const Point& direction);
  void SetUp(vtkTextActor* actor, const std::string& text, double fontSize);

  std::array<int, 2> PictureSize;
  double Scale;
  std::array<double, 3> Color;
  vtkRenderer* Renderer = nullptr;
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkActor2D> LineActor;
  std::vector<vtkSmartPointer<vtkTextActor>> Texts;
};

} // namespace tetmarch

#endif
