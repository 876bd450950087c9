// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridSummary.h"

#include "vtkCell.h"
#include "vtkCellType.h"

#include <algorithm>

namespace tetmarch::testing
{
std::vector<Ids> facesOf(vtkCell* cell)
{
  std::vector<Ids> faces;
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    vtkCell* face = cell->GetFace(f);
    const auto id = [face](int i) { return face->GetPointId(i); };
    const int edges = face->GetNumberOfEdges();
    Ids polygon;
    for (int i = 0; i < edges; ++i)
    {
      polygon.push_back(id(face->GetCellType() == VTK_PIXEL ? i ^ (i >> 1) : i));
      if (face->GetNumberOfPoints() >= 2 * edges)
      {
        polygon.push_back(id(edges + i));
      }
    }
    faces.push_back(polygon);
  }
  return faces;
}

double volumeOf(vtkUnstructuredGrid* grid, const std::vector<Ids>& faces)
{
  double volume = 0.0;
  for (const Ids& face : faces)
  {
    std::vector<Vec3> p(face.size());
    Vec3 mean = { 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      grid->GetPoint(face[i], p[i].data());
      for (int a = 0; a < 3; ++a)
      {
        mean[a] += p[i][a] / static_cast<double>(face.size());
      }
    }
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Vec3& a = p[i];
      const Vec3& b = p[(i + 1) % face.size()];
      volume +=
        (a[0] * (b[1] * mean[2] - b[2] * mean[1]) + a[1] * (b[2] * mean[0] - b[0] * mean[2]) +
          a[2] * (b[0] * mean[1] - b[1] * mean[0])) /
        6.0;
    }
  }
  return volume;
}

GridSummary summarise(vtkUnstructuredGrid* grid)
{
  GridSummary summary;
  std::map<Ids, int> users;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    ++summary.Types[grid->GetCellType(i)];
    const std::vector<Ids> faces = facesOf(grid->GetCell(i));
    const double volume = volumeOf(grid, faces);
    summary.Volume += volume;
    summary.LeastVolume = i == 0 ? volume : std::min(summary.LeastVolume, volume);
    for (Ids face : faces)
    {
      std::sort(face.begin(), face.end());
      ++users[face];
    }
  }
  for (const auto& [face, count] : users)
  {
    ++(count == 2   ? summary.FacesInside
       : count == 1 ? summary.FacesOnBoundary
                    : summary.FacesOfMore);
    if (count == 1)
    {
      summary.Boundary.push_back(face);
    }
  }
  return summary;
}
} // namespace tetmarch::testing
