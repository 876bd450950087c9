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

#include "Overlay.h"

#include <array>

class vtkCamera;

namespace tetmarch
{

class BoxAxes
{
public:
  /// Scale says by how much text is larger than in a picture of 1024 x 768.
  BoxAxes(Overlay& overlay, double scale);

  /// Draws them anew, for a box and a camera, whose projection is that of the whole picture.
  /// Returns false, and draws none, if some of the box is behind the camera.
  bool Place(const std::array<double, 6>& bounds, vtkCamera* camera);

private:
  struct Edge;
  struct Projection;

  void AddAxis(const Projection& projection, const Edge& edge);

  Overlay& Drawn;
  double Scale;
};

} // namespace tetmarch

#endif
