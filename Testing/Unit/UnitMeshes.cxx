// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnitMeshes.h"

#include "vtkPoints.h"

#include <cmath>

namespace tetmarch::testing
{
double sixVolumes(const TetMesh& mesh, const std::array<Id, 4>& vertices)
{
  double e[3][3];
  const Vertex& o = mesh.Vertices[vertices[0]];
  for (int i = 0; i < 3; ++i)
  {
    const Vertex& v = mesh.Vertices[vertices[i + 1]];
    e[i][0] = double(v.X) - double(o.X);
    e[i][1] = double(v.Y) - double(o.Y);
    e[i][2] = double(v.Z) - double(o.Z);
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

double totalVolume(const TetMesh& mesh)
{
  double sum = 0.0;
  for (const auto& tet : mesh.Tets)
  {
    sum += std::abs(sixVolumes(mesh, tet)) / 6.0;
  }
  return sum * mesh.Frame.Radius * mesh.Frame.Radius * mesh.Frame.Radius;
}

const std::vector<NamedGrid>& everyGrid()
{
  static const std::vector<NamedGrid> grids = {
    { "singleTet", [] { return singleTet(); } },
    { "twoTetsSharingFace", [] { return twoTetsSharingFace(); } },
    { "twoTetsSharingEdge", [] { return twoTetsSharingEdge(); } },
    { "twoTetsSharingVertex", [] { return twoTetsSharingVertex(); } },
    { "defectiveTets", [] { return defectiveTets(); } },
    { "mixedDimensions", [] { return mixedDimensions(3); } },
    { "plain lattice", [] { return jitteredLattice(4, 0.0); } },
    { "jittered lattice", [] { return jitteredLattice(5); } },
    { "shuffled lattice", [] { return shuffled(jitteredLattice(5)); } },
    { "lattice far away",
      [] {
        return withOffsetAndScale(jitteredLattice(4), { 1e6, -2e6, 3e6 }, 1e-3);
      } },
    { "squashed lattice",
      []
      {
        const Grid grid = jitteredLattice(4);
        for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
        {
          double p[3];
          grid->GetPoint(i, p);
          grid->GetPoints()->SetPoint(i, p[0], p[1], 1e-5 * p[2]);
        }
        return grid;
      } },
    { "hole", [] { return latticeWithHole(6); } },
    { "tunnel", [] { return latticeWithTunnel(6); } },
    { "L", [] { return lShape(4); } },
    { "two components", [] { return twoComponents(4); } },
    { "shells", [] { return nestedShells(8); } },
    { "hexahedra", [] { return hexLattice(4); } },
    { "warped hexahedra", [] { return hexLattice(4, 0.15); } },
    { "voxels", [] { return voxelLattice(4); } },
    { "warped wedges", [] { return wedgeLattice(4, 0.15); } },
    { "warped pyramids", [] { return pyramidLattice(3, 0.15); } },
    { "warped polyhedra", [] { return polyhedronLattice(4, 0.15); } },
    { "hexagonal prisms", [] { return hexagonalPrismLattice(3); } },
    { "pentagonal prisms", [] { return pentagonalPrismLattice(3); } },
    { "split faces", [] { return splitFacePolyhedron(); } },
    { "mixed cells", [] { return mixedCells(4, 1, 0.1); } },
    { "quadratic tets", [] { return quadraticTetLattice(2, 0.1); } },
    { "quadratic hexahedra", [] { return quadraticHexLattice(2, 0.1); } },
    { "triquadratic hexahedra", [] { return triQuadraticHexLattice(2, 0.1); } },
    { "quadratic wedges", [] { return quadraticWedgeLattice(2, 0.1); } },
    { "quadratic pyramids", [] { return quadraticPyramidLattice(2, 0.1); } },
  };
  return grids;
}

} // namespace tetmarch::testing
