// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/OpaqueSurfaces.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3DCollection.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Matrix = std::array<double, 16>;

Matrix timesMatrixOf(const Matrix& matrix, vtkProp* prop)
{
  vtkMatrix4x4* own = prop->GetMatrix();
  Matrix product = matrix;
  if (own)
  {
    vtkMatrix4x4::Multiply4x4(matrix.data(), own->GetData(), product.data());
  }
  return product;
}

class Collector
{
public:
  explicit Collector(BlockAttributes attributes)
    : Attributes(attributes)
  {
  }

  // The path traversal of assemblies is not used, since the volume may be drawn by an assembly that
  // is traversing its paths. As there, the visibility of parts does not depend on their assembly.
  void addProp(vtkProp* prop, const Matrix& parent)
  {
    const Matrix matrix = timesMatrixOf(parent, prop);
    vtkCollectionSimpleIterator it;
    if (auto* assembly = vtkAssembly::SafeDownCast(prop))
    {
      vtkProp3DCollection* parts = assembly->GetParts();
      parts->InitTraversal(it);
      while (vtkProp3D* part = parts->GetNextProp3D(it))
      {
        this->addProp(part, matrix);
      }
    }
    else if (auto* group = vtkPropAssembly::SafeDownCast(prop))
    {
      vtkPropCollection* parts = group->GetParts();
      parts->InitTraversal(it);
      while (vtkProp* part = parts->GetNextProp(it))
      {
        this->addProp(part, matrix);
      }
    }
    else if (auto* actor = vtkActor::SafeDownCast(prop))
    {
      this->addActor(actor, matrix);
    }
  }

  std::vector<OpaqueSurface> Surfaces;

private:
  void addActor(vtkActor* actor, const Matrix& matrix)
  {
    vtkMapper* mapper = actor->GetMapper();
    if (!actor->GetVisibility() || !mapper ||
        actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
    {
      return;
    }
    mapper->GetBounds(); // updates the input
    if (!actor->HasOpaqueGeometry())
    {
      return;
    }
    if (auto* ofDataSet = vtkDataSetMapper::SafeDownCast(mapper))
    {
      mapper = ofDataSet->GetPolyDataMapper();
    }
    if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
    {
      this->addData(mapper->GetInputDataObject(0, 0), { { nullptr, matrix, actor, mapper, {} } },
        this->Attributes ? this->Attributes(mapper) : nullptr);
    }
  }

  struct Block
  {
    OpaqueSurface Surface;
    bool Visible = true;
    bool Opaque = true;

    void take(vtkDataObject* data, vtkCompositeDataDisplayAttributes* drawn)
    {
      this->Visible =
        drawn->HasBlockVisibility(data) ? drawn->GetBlockVisibility(data) : this->Visible;
      this->Opaque =
        drawn->HasBlockOpacity(data) ? drawn->GetBlockOpacity(data) >= 1 : this->Opaque;
      if (drawn->HasBlockColor(data))
      {
        drawn->GetBlockColor(data, this->Surface.BlockColor.emplace().data());
      }
    }
  };

  // Blocks inherit missing attributes from their parent.
  void addData(vtkDataObject* data, Block block, vtkCompositeDataDisplayAttributes* drawn)
  {
    if (drawn && data)
    {
      block.take(data, drawn);
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
    {
      auto children = vtk::TakeSmartPointer(tree->NewTreeIterator());
      children->VisitOnlyLeavesOff();
      children->TraverseSubTreeOff();
      for (children->InitTraversal(); !children->IsDoneWithTraversal(); children->GoToNextItem())
      {
        this->addData(children->GetCurrentDataObject(), block, drawn);
      }
    }
    block.Surface.Data = vtkPolyData::SafeDownCast(data);
    if (block.Surface.Data && block.Visible && block.Opaque &&
        block.Surface.Data->GetNumberOfPolys() + block.Surface.Data->GetNumberOfStrips() > 0)
    {
      this->Surfaces.push_back(block.Surface);
    }
  }

  BlockAttributes Attributes;
};

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// add(points, size) for each cell.
template <typename Add>
void forEachCell(vtkCellArray* cells, const Add& add)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(size, points);
    add(points, size);
  }
}

void addPoints(vtkPolyData* data, std::vector<Vector3>& points)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points.emplace_back();
    data->GetPoint(i, points.back().data());
  }
}

bool isFinite(const Vector3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

} // namespace

std::vector<OpaqueSurface> opaqueSurfaces(vtkRenderer* renderer, BlockAttributes attributes)
{
  const Matrix identity{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
  Collector collector(attributes);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      collector.addProp(prop, identity);
    }
  }
  return std::move(collector.Surfaces);
}

TriangleHierarchy trianglesOf(const std::vector<vtkPolyData*>& pieces)
{
  std::vector<Vector3> points;
  Triangles triangles;
  for (vtkPolyData* piece : pieces)
  {
    const std::size_t first = points.size();
    addPoints(piece, points);
    const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      const auto corner = [first](vtkIdType point)
      { return static_cast<std::uint32_t>(first + static_cast<std::size_t>(point)); };
      const std::array<std::uint32_t, 3> triangle{ { corner(a), corner(b), corner(c) } };
      if (std::all_of(triangle.begin(), triangle.end(),
            [&points](std::uint32_t i) { return isFinite(points[i]); }))
      {
        triangles.push_back(triangle);
      }
    };
    forEachCell(piece->GetPolys(),
      [&](const vtkIdType* p, vtkIdType size)
      {
        for (vtkIdType i = 2; i < size; ++i)
        {
          add(p[0], p[i - 1], p[i]);
        }
      });
    forEachCell(piece->GetStrips(),
      [&](const vtkIdType* p, vtkIdType size)
      {
        for (vtkIdType i = 2; i < size; ++i)
        {
          add(p[i - 2], p[i - 1], p[i]);
        }
      });
  }
  return { std::move(points), std::move(triangles) };
}

} // namespace tetmarch
