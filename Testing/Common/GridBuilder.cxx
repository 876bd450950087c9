// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridBuilder.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>

namespace tetmarch::testing
{
GridBuilder::GridBuilder(const Vec3& spacing)
  : Spacing(spacing)
  , Result(Grid::New())
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->Result->SetPoints(points);
  this->Result->Allocate();
}

GridBuilder::~GridBuilder() = default;

vtkIdType GridBuilder::addPoint(const Vec3& position)
{
  return this->Result->GetPoints()->InsertNextPoint(position.data());
}

vtkIdType GridBuilder::at(int i, int j, int k)
{
  const auto [entry, isNew] = this->AtLattice.try_emplace({ i, j, k }, 0);
  if (isNew)
  {
    entry->second =
      this->addPoint({ i * this->Spacing[0], j * this->Spacing[1], k * this->Spacing[2] });
  }
  return entry->second;
}

vtkIdType GridBuilder::between(Ids points)
{
  std::sort(points.begin(), points.end());
  const auto [entry, isNew] = this->Between.try_emplace(points, 0);
  if (isNew)
  {
    Vec3 mean = { 0.0, 0.0, 0.0 };
    for (const vtkIdType point : points)
    {
      const Vec3 p = this->position(point);
      for (int a = 0; a < 3; ++a)
      {
        mean[a] += p[a] / static_cast<double>(points.size());
      }
    }
    entry->second = this->addPoint(mean);
  }
  return entry->second;
}

Vec3 GridBuilder::position(vtkIdType point) const
{
  Vec3 p;
  this->Result->GetPoint(point, p.data());
  return p;
}

void GridBuilder::move(vtkIdType point, const Vec3& position)
{
  this->Result->GetPoints()->SetPoint(point, position.data());
}

void GridBuilder::addCell(int vtkCellType, const Ids& points)
{
  this->Result->InsertNextCell(vtkCellType, static_cast<vtkIdType>(points.size()), points.data());
}

void GridBuilder::addPolyhedron(const std::vector<Ids>& faces)
{
  std::set<vtkIdType> distinct;
  Ids stream;
  for (const Ids& face : faces)
  {
    distinct.insert(face.begin(), face.end());
    stream.push_back(static_cast<vtkIdType>(face.size()));
    stream.insert(stream.end(), face.begin(), face.end());
  }
  const Ids points(distinct.begin(), distinct.end());
  this->Result->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(points.size()), points.data(),
    static_cast<vtkIdType>(faces.size()), stream.data());
}

Grid GridBuilder::finish(const Field& field)
{
  attachFields(this->Result, field);
  return this->Result;
}
} // namespace tetmarch::testing
