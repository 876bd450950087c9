// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the seeds of the fuzzer, Corpus/, into the folder that the argument names: small grids of
// Testing/Common as bytes.
#include "GridCode.h"

#include "Grids.h"

#include "vtkCellType.h"

#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <utility>

namespace
{
using namespace tetmarch::testing;

struct Seed
{
  const char* Name;
  Grid Cells;
};

// One cell of a type, on points in no plane.
Grid single(int type, int points)
{
  GridBuilder builder;
  Ids ids;
  for (int i = 0; i < points; ++i)
  {
    ids.push_back(builder.addPoint(
      { 0.37 * (i % 3) + 0.05 * i, 0.41 * (i / 3 % 3) - 0.03 * i, 0.29 * (i / 9) + 0.02 * i * i }));
  }
  builder.addCell(type, ids);
  return builder.finish(linearField());
}

std::vector<Seed> seeds()
{
  return {
    { "single_tet", singleTet() },
    { "sharing_face", twoTetsSharingFace() },
    { "sharing_edge", twoTetsSharingEdge() },
    { "sharing_vertex", twoTetsSharingVertex() },
    { "defective_tets", defectiveTets() },
    { "mixed_dimensions", mixedDimensions(2) },
    { "surfaces", triangleAndLineGrid() },
    { "plain_lattice", jitteredLattice(2, 0.0) },
    { "jittered_lattice", jitteredLattice(2) },
    { "larger_lattice", jitteredLattice(3) },
    { "tangled_lattice", jitteredLattice(2, 0.6) },
    { "shuffled_lattice", shuffled(jitteredLattice(2)) },
    { "l_shape", lShape(2) },
    { "two_components", twoComponents(2) },
    { "hexahedra", hexLattice(2) },
    { "warped_hexahedra", hexLattice(3, 0.15) },
    { "voxels", voxelLattice(2) },
    { "wedges", wedgeLattice(2, 0.15) },
    { "pyramids", pyramidLattice(2, 0.15) },
    { "polyhedra", polyhedronLattice(2) },
    { "warped_polyhedra", polyhedronLattice(3, 0.15) },
    { "pentagonal_prisms", pentagonalPrismLattice(2) },
    { "hexagonal_prisms", hexagonalPrismLattice(2) },
    { "split_faces", splitFacePolyhedron() },
    { "mixed_cells", mixedCells(3, 1, 0.1) },
    { "quadratic_tets", quadraticTetLattice(1, 0.1) },
    { "quadratic_hexahedra", quadraticHexLattice(2, 0.1) },
    { "triquadratic_hexahedra", triQuadraticHexLattice(2, 0.1) },
    { "quadratic_wedges", quadraticWedgeLattice(1, 0.1) },
    { "quadratic_pyramids", quadraticPyramidLattice(1, 0.1) },
    { "convex_point_set", single(VTK_CONVEX_POINT_SET, 7) },
    { "triquadratic_pyramid", single(VTK_TRIQUADRATIC_PYRAMID, 19) },
    { "quadratic_linear_wedge", single(VTK_QUADRATIC_LINEAR_WEDGE, 12) },
    { "biquadratic_wedge", single(VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18) },
    { "biquadratic_hexahedron", single(VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24) },
    { "lagrange_tet", single(VTK_LAGRANGE_TETRAHEDRON, 20) },
    { "lagrange_tet_15", single(VTK_LAGRANGE_TETRAHEDRON, 15) },
    { "lagrange_hexahedron", single(VTK_LAGRANGE_HEXAHEDRON, 27) },
    { "lagrange_wedge", single(VTK_LAGRANGE_WEDGE, 18) },
    { "lagrange_wedge_21", single(VTK_LAGRANGE_WEDGE, 21) },
    { "bezier_tet", single(VTK_BEZIER_TETRAHEDRON, 10) },
    { "bezier_hexahedron", single(VTK_BEZIER_HEXAHEDRON, 27) },
    { "bezier_wedge", single(VTK_BEZIER_WEDGE, 18) },
  };
}
} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 1;
  }
  std::uint8_t number = 0;
  for (const Seed& seed : seeds())
  {
    // Flags in turn: storage, type of points, scalars of cells, gray functions, opacity law.
    const std::uint8_t flags =
      static_cast<std::uint8_t>((number % 16) | (number % 5 == 4 ? 64 : 0));
    const Bytes bytes = encode(seed.Cells, flags, number++);
    std::ofstream file(std::string(argv[1]) + "/" + seed.Name, std::ios::binary);
    file.write(
      reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file)
    {
      std::fprintf(stderr, "%s can't be written\n", seed.Name);
      return 1;
    }
  }
  return 0;
}
