// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which lengths of which values the rays of a small picture cross, found without marching a ray:
// the volume of each cell is handed out to the pixels before which it lies, and the volume before a
// pixel, divided by its area, is the mean length of its rays. It is enough to choose an exposure,
// takes any kind of cell, and neither needs OpenGL nor links between cells.
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
  Vector3 Place;
};

struct Crossings
{
  int Width = 0; // of the picture, in pixels
  int Height = 0;
  std::vector<Crossing> List;

  // Of each pixel, the sum over its lengths by extinction(value), the extinction at a unit distance
  // of 1.
  std::vector<double> opticalDepths(const std::function<double(double)>& extinction) const;
  // Of each pixel, by the same sum: the length within the data.
  std::vector<double> lengths() const;

  // Each as a cell that covers as much of a picture as it is long.
  std::vector<Sample> samples() const;
  // Where the extinction is more than a hundredth of the greatest.
  std::vector<Vector3> shownPlaces(const std::function<double(double)>& extinction) const;
};

// Of a parallel projection in which the points fill the picture. Of each block about a hundred
// thousand cells, one at random of each so many in turn, stand for all; the same data give the same
// crossings. Values that aren't finite have none.
Crossings findCrossings(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn,
  const std::vector<Vector3>& points, const PicturePlane& plane);

} // namespace tetmarch

#endif
