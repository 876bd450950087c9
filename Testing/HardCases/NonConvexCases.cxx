// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that a ray leaves and enters again.
#include "CaseGroup.h"
#include "CaseViews.h"
#include "SwissCheese.h"

#include "Grids.h"

namespace tetmarch::testing
{
namespace
{
void addShapes(CaseGroup& group)
{
  group.add("torus", "a smooth ring", [] { return torus(36, 3, sineField(0.4)); });
  group.add("nested-shells", "a ball in shells, which touch in edges and vertices",
    [] { return nestedShells(12); });
  group.add("cavity", "a cube with a closed hole inside", [] { return latticeWithHole(6); });
  group.add("l-shape", "a cube without a quarter", [] { return lShape(6); });
  group.add("tunnel", "a cube bored through", [] { return latticeWithTunnel(6); });

  HardCase& coil =
    group.add("spiral", "a band of four turns", [] { return spiral(4.0, 160, sineField(0.5)); });
  coil.Views = standardViews();
  coil.Views.push_back(parallelView("across", { 1, 0, 0 }, { 0, 0, 1 }, 0.3));
}

void addManyEntries(CaseGroup& group)
{
  HardCase& teeth = group.add("comb", "1000 teeth on one bar: a ray along them enters 1000 times",
    [] { return comb(1000, sineField(0.7)); });
  teeth.Views = standardViews();
  // Half the diagonal of a bar of 2 x 1/8 x 1/4 is about 1, half of its end's height 1/8.
  teeth.Views.push_back(parallelView("along-row", { 1, 0, 0 }, { 0, 0, 1 }, 0.13));
  teeth.Views.back().ReferenceOnly = true;
  teeth.Views.push_back(parallelView("nearly-along-row", { 1, 0.01, -0.02 }, { 0, 0, 1 }, 0.13));
  teeth.Views.back().ReferenceOnly = true;
  teeth.Views.push_back(viewFrom(
    "in-front-of-row",
    [](vtkUnstructuredGrid*) {
      return Vec3{ -0.25, 0.0625, 0.1875 };
    },
    { 1, 0, 0 }, { 0, 0, 1 }, 30.0));

  HardCase& stack = group.add(
    "sheets", "40 sheets one cell thick with gaps of 1e-4", [] { return sheets(40, 4, 1e-4); });
  stack.Views = standardViews();
  stack.Views.push_back(parallelView("through-sheets", { 0.05, 0.03, -1 }, { 0, 1, 0 }, 0.9));
  stack.Views.push_back(parallelView("along-sheets", { 1, 0, 0 }, { 0, 0, 1 }, 0.9));
  stack.Views.push_back(parallelView("nearly-along-sheets", { 1, 0.3, 0.004 }, { 0, 0, 1 }, 0.9));

  group.add("swiss-cheese", "what a threshold of noise leaves of a lattice: 1e5 boundary faces",
    [] { return swissCheese(42, 28); });
}

// A jittered cube and its image in the planes x = 1, y = 1 and z = 1, as many of them as said:
// where the two meet, their points and triangles coincide.
Grid withMirrorImage(int planes)
{
  const Grid cube = jitteredLattice(4);
  return joined(cube, mapped(cube,
                        [planes](Vec3 p, vtkIdType)
                        {
                          for (int a = 0; a < planes; ++a)
                          {
                            p[a] = 2.0 - p[a];
                          }
                          return p;
                        }));
}

void addComponents(CaseGroup& group)
{
  fills(group.add("touching-in-face", "two cubes that touch in a face whose points are there twice",
          [] { return withMirrorImage(1); }),
    { { 0, 0, 0 }, { 2, 1, 1 } });
  group.add("touching-in-edge", "two cubes that touch in an edge whose points are there twice",
    [] { return withMirrorImage(2); });
  group.add("touching-in-vertex", "two cubes that touch in a vertex that is there twice",
    [] { return withMirrorImage(3); });
  group.add("overlapping", "two cubes that interpenetrate",
    []
    {
      return joined(jitteredLattice(4),
        withOffsetAndScale(jitteredLattice(5, 0.15, 2), { 0.5, 0.3, 0.2 }, 1.0));
    });
  group.add("one-in-another", "a small cube inside a large one",
    []
    {
      return joined(jitteredLattice(4),
        withOffsetAndScale(jitteredLattice(4, 0.15, 2), { 0.3, 0.35, 0.4 }, 0.3));
    });
}
} // namespace

void addNonConvexCases(std::vector<HardCase>& cases)
{
  CaseGroup group(cases, "non-convex");
  addShapes(group);
  addManyEntries(group);
  addComponents(group);
}
} // namespace tetmarch::testing
