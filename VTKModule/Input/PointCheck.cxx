// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/PointCheck.h"

#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <sstream>

namespace tetmarch
{

std::vector<char> findSoundPoints(vtkPoints* points)
{
  const vtkIdType count = points->GetNumberOfPoints();
  std::vector<char> sound(count, 1);
  vtkSMPTools::For(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double p[3];
        points->GetPoint(i, p);
        sound[i] = isSound(p[0]) && isSound(p[1]) && isSound(p[2]);
      }
    });
  const bool all = std::find(sound.begin(), sound.end(), 0) == sound.end();
  return all ? std::vector<char>() : sound;
}

std::string describeUnsoundPoint(vtkPoints* points, vtkIdType point, vtkIdType cell)
{
  double p[3];
  points->GetPoint(point, p);
  const int wrong = isSound(p[0]) ? (isSound(p[1]) ? 2 : 1) : 0;
  std::ostringstream text;
  text << "Coordinate " << wrong << " of point " << point << ", which cell " << cell << " has, is "
       << p[wrong]
       << (std::isfinite(p[wrong]) ? ", which is larger than 1e100" : ", not a finite number")
       << ". Repair the grid's points.";
  return text.str();
}

} // namespace tetmarch
