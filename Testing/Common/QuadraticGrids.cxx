// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"

#include "vtkCellType.h"
#include "vtkMath.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
// The corners that each further node stands between, in the node order of vtkQuadraticTetra.h and
// its siblings.
const std::vector<Ids> TetNodes = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
const std::vector<Ids> HexNodes = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
  { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
const std::vector<Ids> HexFaceNodes = { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
  { 3, 0, 4, 7 }, { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 2, 3, 4, 5, 6, 7 } };
const std::vector<Ids> WedgeNodes = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 },
  { 0, 3 }, { 1, 4 }, { 2, 5 } };
const std::vector<Ids> PyramidNodes = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 },
  { 2, 4 }, { 3, 4 } };

class QuadraticLattice
{
public:
  QuadraticLattice(int n, double curvature)
    : Lattice(n, 0.0)
    , Bend(curvature / n)
  {
  }

  void add(int type, const Ids& corners, const std::vector<Ids>& nodes)
  {
    Ids points = corners;
    for (const Ids& node : nodes)
    {
      Ids ends;
      for (const vtkIdType corner : node)
      {
        ends.push_back(corners[static_cast<std::size_t>(corner)]);
      }
      points.push_back(this->Lattice.Builder.between(ends));
      this->Bent.resize(static_cast<std::size_t>(points.back()) + 1, true);
      this->Bent[static_cast<std::size_t>(points.back())] = false;
    }
    this->Lattice.Builder.addCell(type, points);
  }

  Grid finish(const Field& field)
  {
    GridBuilder& builder = this->Lattice.Builder;
    for (std::size_t i = 0; i < this->Bent.size(); ++i)
    {
      if (!this->Bent[i])
      {
        const auto id = static_cast<vtkIdType>(i);
        Vec3 p = builder.position(id);
        const Vec3 bend = bendDirection(p);
        for (int a = 0; a < 3; ++a)
        {
          p[a] += this->Bend * bend[a];
        }
        builder.move(id, p);
      }
    }
    return builder.finish(field);
  }

  CubeLattice Lattice;

private:
  const double Bend;
  std::vector<bool> Bent; // by point; corners count as bent, they stay where they are
};
} // namespace

Vec3 bendDirection(const Vec3& p)
{
  const double pi = vtkMath::Pi();
  const double bubble = std::sin(pi * p[0]) * std::sin(pi * p[1]) * std::sin(pi * p[2]);
  return { bubble, -0.7 * bubble, 0.4 * bubble };
}

Grid quadraticTetLattice(int n, double curvature, const Field& field)
{
  QuadraticLattice quadratic(n, curvature);
  quadratic.Lattice.forEachCube(
    [&](const Ids& cube)
    {
      for (const auto& tet : KuhnTets)
      {
        quadratic.add(VTK_QUADRATIC_TETRA, pick(cube, tet), TetNodes);
      }
    });
  return quadratic.finish(field);
}

Grid quadraticHexLattice(int n, double curvature, const Field& field)
{
  QuadraticLattice quadratic(n, curvature);
  quadratic.Lattice.forEachCube([&](const Ids& cube)
    { quadratic.add(VTK_QUADRATIC_HEXAHEDRON, pick(cube, HexCorners), HexNodes); });
  return quadratic.finish(field);
}

Grid triQuadraticHexLattice(int n, double curvature, const Field& field)
{
  // vtkTriQuadraticHexahedron's faces come as -x, +x, -y, +y, -z, +z, then the centre.
  std::vector<Ids> nodes = HexNodes;
  for (const std::size_t face : { 3, 1, 0, 2, 4, 5, 6 })
  {
    nodes.push_back(HexFaceNodes[face]);
  }
  QuadraticLattice quadratic(n, curvature);
  quadratic.Lattice.forEachCube([&](const Ids& cube)
    { quadratic.add(VTK_TRIQUADRATIC_HEXAHEDRON, pick(cube, HexCorners), nodes); });
  return quadratic.finish(field);
}

Grid quadraticWedgeLattice(int n, double curvature, const Field& field)
{
  QuadraticLattice quadratic(n, curvature);
  quadratic.Lattice.forEachCube(
    [&](const Ids& cube)
    {
      for (const auto& wedge : CubeWedges)
      {
        quadratic.add(VTK_QUADRATIC_WEDGE, pick(cube, wedge), WedgeNodes);
      }
    });
  return quadratic.finish(field);
}

Grid quadraticPyramidLattice(int n, double curvature, const Field& field)
{
  QuadraticLattice quadratic(n, curvature);
  quadratic.Lattice.forEachCube(
    [&](const Ids& cube)
    {
      const vtkIdType tip = quadratic.Lattice.Builder.between(cube);
      for (const auto& face : CubeFaces)
      {
        const Ids base = pick(cube, face);
        quadratic.add(
          VTK_QUADRATIC_PYRAMID, { base[0], base[3], base[2], base[1], tip }, PyramidNodes);
      }
    });
  return quadratic.finish(field);
}
} // namespace tetmarch::testing
