// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines, rectangles and text over the scene, in pixels of the whole picture from its lower left.
 */
#ifndef tetmarch_Overlay_h
#define tetmarch_Overlay_h

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"

#include <array>
#include <string>
#include <vector>

class vtkPolyDataMapper2D;
class vtkRenderer;

namespace tetmarch
{

class Overlay
{
public:
  using Point = std::array<double, 2>;

  enum Anchors
  {
    CENTER,
    LEFT // the middle of the left side
  };

  /// The colour is that of lines and text.
  Overlay(const std::array<int, 2>& pictureSize, const std::array<double, 3>& color,
    double lineWidth, vtkRenderer* renderer);

  const std::array<int, 2>& GetPictureSize() const { return this->PictureSize; }

  void Clear();
  void AddLine(const Point& a, const Point& b);
  /// Below lines and text, and over the rectangles before it.
  void AddRectangle(
    const Point& low, const Point& high, const std::array<double, 3>& color, double opacity = 1.0);
  void AddText(const std::string& text, double size, const Point& place, Anchors anchor = CENTER);

  /// Width and height of text in pixels.
  static std::array<int, 2> Measure(const std::string& text, double size);

  /// The wished size, or a smaller one with which none of the texts is wider.
  static double FindSize(const std::vector<std::string>& texts, double wished, double width);

private:
  void AddActor(vtkPolyData* data, double lineWidth);
  vtkIdType AddPoint(vtkPolyData* data, const Point& point);

  std::array<int, 2> PictureSize;
  std::array<double, 3> Color;
  vtkRenderer* Renderer;
  vtkNew<vtkPolyData> Rectangles;
  vtkNew<vtkPolyData> Lines;
  std::vector<vtkSmartPointer<vtkTextActor>> Texts;
};

} // namespace tetmarch

#endif
