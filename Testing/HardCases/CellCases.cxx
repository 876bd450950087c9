// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that no mesh should have, and neighbours that don't fit.
#include "CaseGroup.h"
#include "CaseViews.h"

#include "Grids.h"

#include <cmath>
#include <limits>

namespace tetmarch::testing
{
namespace
{
const Box TwoCubes = { { 0, 0, 0 }, { 2, 1, 1 } };

void addSlivers(CaseGroup& group)
{
  for (int exponent = 3; exponent <= 8; ++exponent)
  {
    const std::string power = "1e-" + std::to_string(exponent);
    const double squash = std::pow(10.0, -exponent);
    fills(group.add("squashed-" + power,
      "every second layer of a lattice is only " + power + " as high as wide",
      [squash] { return squashedLayers(8, squash); }));
  }

  HardCase& fan = group.add("needle-fan", "1000 tetrahedra round one edge, also seen along it",
    [] { return needleFan(1000, 1.0, sineField(0.4)); });
  fan.Views = standardViews();
  // The edge is the ray of a pixel centre, next to the window's middle if that is none.
  for (const int pixels : { 64, 65 })
  {
    fan.Views.push_back(viewOnPixels("end-on-" + std::to_string(pixels), pixels, { 0, 0, 0 },
      { 1, 0, 0 }, { 0, 1, 0 }, 1.0 / 32.0));
  }
  HardView above = viewFrom(
    "end-on-perspective",
    [](vtkUnstructuredGrid*) {
      return Vec3{ 0, 0, 3 };
    },
    { 0, 0, -1 }, { 0, 1, 0 }, 40.0);
  above.Pixels = 65;
  fan.Views.push_back(above);

  fills(group.add("flat-inside", "lattice with 54 tetrahedra of exactly no volume inside",
    [] { return flatTetsInside(8); }));
  fills(group.add("flat-on-boundary", "lattice with 36 flat tetrahedra within its sides",
    [] { return flatTetsOnBoundary(8); }));
  fills(group.add("edges-without-length", "points inside a lattice that lie exactly on a neighbour",
    [] { return edgesWithoutLength(8); }));
  fills(group.add("repeated-points", "cells that name a point two, three and four times",
    [] { return cellsWithRepeatedPoints(8); }));
}

void addTurnedCells(CaseGroup& group)
{
  fills(group.add("jittered-cube", "a sound mesh, with which others are compared", jitteredCube));
  const auto sameMesh = [&group](const char* name, const char* what, std::function<Grid()> make)
  { fills(group.add(name, what, std::move(make))).SamePictureAs = "jittered-cube"; };
  sameMesh("reversed-all", "all tetrahedra in the order of negative volume",
    [] { return withReversedCells(jitteredCube(), 1); });
  sameMesh("reversed-every-second", "every second tetrahedron in the order of negative volume",
    [] { return withReversedCells(jitteredCube(), 2); });
  sameMesh("repeated-cells", "every third cell is there twice",
    [] { return withRepeatedCells(jitteredCube(), 3); });
  sameMesh("repeated-mesh", "all cells are there twice, with the same points",
    [] { return withRepeatedCells(jitteredCube(), 1); });
  sameMesh("two-equal-meshes", "the mesh twice in the same place, without common points",
    [] { return joined(jitteredCube(), jitteredCube()); });
  sameMesh("points-of-each-cell", "each tetrahedron has points of its own, with equal coordinates",
    [] { return withRepeatedPoints(jitteredCube()); });
  sameMesh("crack", "points not welded in half of a layer: a crack without width",
    [] { return withCrack(jitteredCube(), 6); });

  fills(group.add("tangled-inside",
    "points inside moved beyond their neighbours: tetrahedra turned inside out overlap",
    [] { return jitteredLattice(6, 0.9); }));
  group.add("tangled", "the same with points of the boundary moved too",
    []
    {
      std::mt19937 generator(7);
      const Grid grid = mapped(jitteredLattice(6, 0.0),
        [&generator](Vec3 p, vtkIdType)
        {
          for (double& x : p)
          {
            x += 0.9 / 6.0 * (2.0 * uniform(generator) - 1.0);
          }
          return p;
        });
      attachFields(grid, linearField());
      return grid;
    });
}

// Two cubes side by side, the second from x = begin on, whose triangles don't match there.
Grid cubesSideBySide(double begin)
{
  return joined(jitteredLattice(5), mapped(jitteredLattice(4, 0.15, 2),
                                      [begin](const Vec3& p, vtkIdType) {
                                        return Vec3{ begin + p[0], p[1], p[2] };
                                      }));
}

void addSeams(CaseGroup& group)
{
  fills(group.add("cubes-side-by-side",
          "two meshes that touch in a square, without common points or matching triangles",
          [] { return cubesSideBySide(1.0); }),
    TwoCubes);
  const auto seam = [&group](const char* name, const char* what, double begin, bool isFloat)
  {
    group
      .add(name, what,
        [=]
        {
          const Grid grid = cubesSideBySide(begin);
          return isFloat ? withFloatPoints(grid) : grid;
        })
      .SamePictureAs = "cubes-side-by-side";
  };
  seam("gap-of-one-ulp", "the same, one double apart", std::nextafter(1.0, 2.0), false);
  seam(
    "overlap-of-one-ulp", "the same, overlapping by one double", std::nextafter(1.0, 0.0), false);
  seam("gap-of-one-float-ulp", "float points, one float apart", std::nextafter(1.0f, 2.0f), true);
  seam("overlap-of-one-float-ulp", "float points, overlapping by one float",
    std::nextafter(1.0f, 0.0f), true);

  fills(group.add("hanging-nodes", "cubes beside cubes of half the size: faces that don't match",
    [] { return hangingNodes(4); }));
  group.add("hanging-nodes-bulging", "the same, with gaps and overlaps where they meet",
    [] { return hangingNodes(4, 0.2); });
}

void addNonManifold(CaseGroup& group)
{
  group.add("face-of-three", "three tetrahedra on one face", [] { return faceOfThreeTets(); });
  group.add("faces-of-three", "a lattice with a third owner of a face in every cube",
    [] { return latticeWithThirdOwners(5); });
  group.add("moebius", "a ring of tetrahedra that closes turned over: not orientable",
    [] { return moebiusRing(48, sineField(0.4)); });
  group.add("one-tet", "a single tetrahedron", [] { return singleTet(); });
  group.add(
    "common-edge", "two tetrahedra that share an edge", [] { return twoTetsSharingEdge(); });
  group.add(
    "common-vertex", "two tetrahedra that share a vertex", [] { return twoTetsSharingVertex(); });
}
} // namespace

void addCellCases(std::vector<HardCase>& cases)
{
  CaseGroup group(cases, "cells");
  addSlivers(group);
  addTurnedCells(group);
  addSeams(group);
  addNonManifold(group);
}
} // namespace tetmarch::testing
