// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lengths of values along the rays of a small picture, estimated without marching rays: the
// volume of each cell is distributed to the pixels that it covers, and the volume in front of a
// pixel, divided by its area, is the mean length of its rays. This suffices to choose an exposure,
// works for any type of cell, and needs neither OpenGL nor links between cells.
#ifndef TetMarchFirstPictureCrossings_h
#define TetMarchFirstPictureCrossings_h

#include "FirstPicture/DrawnArray.h"
#include "FirstPicture/PicturePlane.h"
#include "FirstPicture/Samples.h"

#include <functional>
#include <vector>

namespace tetmarch
{

struct Crossing
{
  int Pixel;
  double Length;
  double Value;
};

struct Crossings
{
  int Width = 0; // of the picture, in pixels
  int Height = 0;
  std::vector<Crossing> List;

  // For each pixel the sum of its lengths times extinction(value), the extinction at a unit
  // distance of 1.
  std::vector<double> opticalDepths(const std::function<double(double)>& extinction) const;
  // For each pixel the length within the data.
  std::vector<double> lengths() const;

  // Each length as a cell with a proportional area.
  std::vector<Sample> samples() const;
};

// For a parallel projection in which the points fill the picture. About a hundred thousand cells of
// each block are sampled, one at random from each of equal ranges of cells; the result is
// deterministic. Values that aren't finite have no crossings.
Crossings findCrossings(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn,
  const std::vector<Vector3>& points, const PicturePlane& plane);

} // namespace tetmarch

#endif
