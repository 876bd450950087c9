// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LagrangeGrids.h"

#include "CubeTopology.h"
#include "QuadraticGrids.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkNew.h"

namespace tetmarch::testing
{
namespace
{
using Node = std::array<int, 3>;

// Corner b of the cube at a node of the lattice of all points.
Node cornerOf(const Node& cube, const std::array<int, 3>& degrees, int b)
{
  return { (cube[0] + (b & 1)) * degrees[0], (cube[1] + ((b >> 1) & 1)) * degrees[1],
    (cube[2] + (b >> 2)) * degrees[2] };
}

// Of points with weights that add up to their denominator.
Node mean(const std::vector<std::pair<Node, int>>& weighted, int denominator)
{
  Node sum{ 0, 0, 0 };
  for (const auto& [node, weight] : weighted)
  {
    for (int a = 0; a < 3; ++a)
    {
      sum[a] += weight * node[a];
    }
  }
  return { sum[0] / denominator, sum[1] / denominator, sum[2] / denominator };
}

class LagrangeLattice
{
public:
  LagrangeLattice(int n, const std::array<int, 3>& degrees, double curvature)
    : Degrees(degrees)
    , Builder({ 1.0 / (n * degrees[0]), 1.0 / (n * degrees[1]), 1.0 / (n * degrees[2]) })
    , Bend(curvature / n)
  {
  }

  vtkIdType at(const Node& node)
  {
    const vtkIdType id = this->Builder.at(node[0], node[1], node[2]);
    this->Points = std::max(this->Points, id + 1);
    return id;
  }

  void addHexahedron(const Node& cube)
  {
    const Node low = cornerOf(cube, this->Degrees, 0);
    const std::array<int, 3>& d = this->Degrees;
    Ids ids(static_cast<std::size_t>((d[0] + 1) * (d[1] + 1) * (d[2] + 1)));
    for (int k = 0; k <= d[2]; ++k)
    {
      for (int j = 0; j <= d[1]; ++j)
      {
        for (int i = 0; i <= d[0]; ++i)
        {
          ids[vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, d.data())] =
            this->at({ low[0] + i, low[1] + j, low[2] + k });
        }
      }
    }
    this->Builder.addCell(VTK_LAGRANGE_HEXAHEDRON, ids);
  }

  void addWedge(const Node& cube, const int (&corners)[6])
  {
    const int n = this->Degrees[0];
    Ids ids(static_cast<std::size_t>((n + 1) * (n + 2) / 2 * (this->Degrees[2] + 1)));
    for (int k = 0; k <= this->Degrees[2]; ++k)
    {
      for (int j = 0; j <= n; ++j)
      {
        for (int i = 0; i + j <= n; ++i)
        {
          Node node = mean({ { cornerOf(cube, this->Degrees, corners[0]), n - i - j },
                             { cornerOf(cube, this->Degrees, corners[1]), i },
                             { cornerOf(cube, this->Degrees, corners[2]), j } },
            n);
          node[2] += k;
          ids[vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, this->Degrees.data())] =
            this->at(node);
        }
      }
    }
    this->Builder.addCell(VTK_LAGRANGE_WEDGE, ids);
  }

  void addTetrahedron(const Node& cube, const int (&corners)[4])
  {
    const int n = this->Degrees[0];
    Ids ids(static_cast<std::size_t>((n + 1) * (n + 2) * (n + 3) / 6));
    for (int k = 0; k <= n; ++k)
    {
      for (int j = 0; j + k <= n; ++j)
      {
        for (int i = 0; i + j + k <= n; ++i)
        {
          // The weights of the corners 1, 2, 3 and 0.
          const vtkIdType weights[4] = { i, j, k, n - i - j - k };
          ids[vtkHigherOrderTetra::Index(weights, n)] =
            this->at(mean({ { cornerOf(cube, this->Degrees, corners[1]), i },
                            { cornerOf(cube, this->Degrees, corners[2]), j },
                            { cornerOf(cube, this->Degrees, corners[3]), k },
                            { cornerOf(cube, this->Degrees, corners[0]), n - i - j - k } },
              n));
        }
      }
    }
    this->Builder.addCell(VTK_LAGRANGE_TETRAHEDRON, ids);
  }

  Grid finish(const Field& field)
  {
    for (vtkIdType id = 0; id < this->Points; ++id)
    {
      Vec3 p = this->Builder.position(id);
      const Vec3 bend = bendDirection(p);
      for (int a = 0; a < 3; ++a)
      {
        p[a] += this->Bend * bend[a];
      }
      this->Builder.move(id, p);
    }
    return this->Builder.finish(field);
  }

private:
  const std::array<int, 3> Degrees;
  GridBuilder Builder;
  const double Bend;
  vtkIdType Points = 0;
};

template <typename Visit>
void forEachCube(int n, Visit&& visit)
{
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        visit(Node{ i, j, k });
      }
    }
  }
}

void addDegrees(vtkUnstructuredGrid* grid, const std::array<int, 3>& degrees)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("degrees");
  array->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    array->InsertNextTuple3(degrees[0], degrees[1], degrees[2]);
  }
  grid->GetCellData()->SetHigherOrderDegrees(array);
}
} // namespace

Grid lagrangeLattice(
  int type, int n, const std::array<int, 3>& degrees, double curvature, const Field& field)
{
  LagrangeLattice lattice(n, degrees, curvature);
  forEachCube(n,
    [&](const Node& cube)
    {
      if (type == VTK_LAGRANGE_HEXAHEDRON)
      {
        lattice.addHexahedron(cube);
      }
      for (const auto& wedge : CubeWedges)
      {
        if (type == VTK_LAGRANGE_WEDGE)
        {
          lattice.addWedge(cube, wedge);
        }
      }
      for (const auto& tet : KuhnTets)
      {
        if (type == VTK_LAGRANGE_TETRAHEDRON)
        {
          lattice.addTetrahedron(cube, tet);
        }
      }
    });
  const Grid grid = lattice.finish(field);
  if (degrees[0] != degrees[1] || degrees[1] != degrees[2])
  {
    addDegrees(grid, degrees);
  }
  return grid;
}

Grid patchLattice(int n, int parts, double curvature, const Field& field)
{
  GridBuilder builder;
  const int side = parts + 1;
  const auto place = [&](const Node& cube, int i, int j, int k)
  {
    const double spacing = 1.0 / (n * parts);
    Vec3 p{ (cube[0] * parts + i) * spacing, (cube[1] * parts + j) * spacing,
      (cube[2] * parts + k) * spacing };
    const Vec3 bend = bendDirection(p);
    for (int a = 0; a < 3; ++a)
    {
      p[a] += curvature / n * bend[a];
    }
    return p;
  };
  forEachCube(n,
    [&](const Node& cube)
    {
      Ids points;
      for (int i = 0; i < side * side * side; ++i)
      {
        points.push_back(builder.addPoint(place(cube, i % side, i / side % side, i / side / side)));
      }
      forEachCube(parts,
        [&](const Node& part)
        {
          Ids corners;
          for (const int b : HexCorners)
          {
            const Node corner = cornerOf(part, { 1, 1, 1 }, b);
            corners.push_back(points[corner[0] + side * (corner[1] + side * corner[2])]);
          }
          builder.addCell(VTK_HEXAHEDRON, corners);
        });
    });
  return builder.finish(field);
}
} // namespace tetmarch::testing
