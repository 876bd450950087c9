// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeafTrees.h"

#include "CubeTopology.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTree.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridNonOrientedGeometryCursor.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace tetmarch::testing
{
namespace
{
class TreeMaker
{
public:
  TreeMaker(int roots, const Field& field, const NodeTest& divides, const NodeTest& masks)
    : F(field)
    , Divides(divides)
    , Masks(masks)
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i <= roots; ++i)
    {
      coordinates->InsertNextValue(double(i) / roots);
    }
    const auto count = static_cast<unsigned int>(roots) + 1;
    this->Trees->SetDimensions(count, count, count);
    this->Trees->SetBranchFactor(2);
    this->Trees->SetXCoordinates(coordinates);
    this->Trees->SetYCoordinates(coordinates);
    this->Trees->SetZCoordinates(coordinates);
    this->OfNodes->SetName("c");
    this->OfLeaves->SetName("c");
    this->Leaves->SetPoints(this->Points);
    this->Points->SetDataTypeToDouble();
  }

  LeafTrees make()
  {
    vtkNew<vtkHyperTreeGridNonOrientedGeometryCursor> cursor;
    vtkIdType first = 0;
    for (vtkIdType root = 0; root < this->Trees->GetMaxNumberOfTrees(); ++root)
    {
      this->Trees->InitializeNonOrientedGeometryCursor(cursor, root, true);
      cursor->SetGlobalIndexStart(first);
      this->visit(cursor, 0);
      first += cursor->GetTree()->GetNumberOfVertices();
    }
    this->Trees->GetCellData()->SetScalars(this->OfNodes);
    this->Trees->SetMask(this->Mask);
    this->Leaves->GetCellData()->SetScalars(this->OfLeaves);
    return { this->Trees, this->Leaves };
  }

private:
  void visit(vtkHyperTreeGridNonOrientedGeometryCursor* cursor, int level)
  {
    double bounds[6];
    cursor->GetBounds(bounds);
    const Node node{ { bounds[0], bounds[2], bounds[4] }, bounds[1] - bounds[0], level };
    const Vec3 middle = node.middle();
    const double value = this->F(middle[0], middle[1], middle[2]);
    const bool divided = this->Divides(node);
    const bool masked = !divided && this->Masks && this->Masks(node);
    this->OfNodes->InsertValue(cursor->GetGlobalNodeIndex(), value);
    this->Mask->InsertValue(cursor->GetGlobalNodeIndex(), masked ? 1 : 0);
    if (!divided && !masked)
    {
      this->addLeaf(bounds, value);
    }
    if (divided)
    {
      cursor->SubdivideLeaf();
      for (unsigned char child = 0; child < 8; ++child)
      {
        cursor->ToChild(child);
        this->visit(cursor, level + 1);
        cursor->ToParent();
      }
    }
  }

  void addLeaf(const double bounds[6], double value)
  {
    vtkIdType ids[8];
    for (int i = 0; i < 8; ++i)
    {
      const int corner = HexCorners[i];
      ids[i] = this->Points->InsertNextPoint(
        bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)]);
    }
    this->Leaves->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
    this->OfLeaves->InsertNextValue(value);
  }

  const Field& F;
  const NodeTest& Divides;
  const NodeTest& Masks;
  vtkSmartPointer<vtkHyperTreeGrid> Trees = vtkSmartPointer<vtkHyperTreeGrid>::New();
  Grid Leaves = Grid::New();
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> OfNodes;
  vtkNew<vtkDoubleArray> OfLeaves;
  vtkNew<vtkBitArray> Mask;
};
} // namespace

Vec3 Node::middle() const
{
  const double half = 0.5 * this->Width;
  return { this->Low[0] + half, this->Low[1] + half, this->Low[2] + half };
}

LeafTrees leafTrees(int roots, const Field& field, const NodeTest& divides, const NodeTest& masks)
{
  return TreeMaker(roots, field, divides, masks).make();
}
} // namespace tetmarch::testing
