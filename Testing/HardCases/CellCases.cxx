// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Groups.h"

#include "Grids.h"
#include "Views.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
HardCase cellCase(
  const std::string& name, const std::string& what, const std::function<Grid()>& make)
{
  HardCase hard;
  hard.Name = name;
  hard.Group = "cells";
  hard.What = what;
  hard.Make = make;
  return hard;
}

HardCase boxCase(const std::string& name, const std::string& what,
  const std::function<Grid()>& make, const Box& box = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } })
{
  HardCase hard = cellCase(name, what, make);
  hard.Known = Answer::Box;
  hard.ExactBox = box;
  return hard;
}

Grid cube(int n = 4, double jitter = 0.15) { return jitteredLattice(n, jitter, 3, sineField()); }

void addSlivers(HardCases& cases)
{
  for (int k = 3; k <= 8; ++k)
  {
    const double squash = std::pow(10.0, -k);
    cases.push_back(boxCase("squashed-1e-" + std::to_string(k),
      "a lattice squashed along z by 1e-" + std::to_string(k),
      [=]
      {
        return movedPoints(cube(),
          [=](const Vec3& p, vtkIdType) {
            return Vec3{ p[0], p[1], squash * p[2] };
          });
      },
      { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, squash } }));
    cases.push_back(boxCase("sliver-layer-1e-" + std::to_string(k),
      "a layer of cells in a sound lattice squashed by 1e-" + std::to_string(k),
      [=]
      {
        return movedPoints(cube(4, 0.0),
          [=](const Vec3& p, vtkIdType) {
            return Vec3{ p[0], p[1], p[2] == 0.5 ? 0.25 + 0.25 * squash : p[2] };
          });
      }));
  }
  cases.push_back(cellCase("needle-fan", "1000 tetrahedra round one edge",
    [] { return needleFan(1000, 0.5, sineField()); }));
  cases.back().Views = standardViews();
  cases.back().Views.push_back(parallelAlong("down-the-edge", { 0.0, 0.0, 1.0 }, 1.0));
  cases.back().Views.push_back(parallelAlong("onto-the-edge", { 1.0, 0.0, 0.0 }, 1.0));
  cases.push_back(cellCase("needle-fan-thin", "1000 tetrahedra round one edge, within 1e-4 of it",
    [] { return needleFan(1000, 1e-4, sineField()); }));
}

void addFlatCells(HardCases& cases)
{
  cases.push_back(boxCase("flat-layer-inside", "a layer of cells without volume inside",
    []
    {
      return movedPoints(cube(4, 0.0),
        [](const Vec3& p, vtkIdType) {
          return Vec3{ p[0], p[1], p[2] == 0.5 ? 0.25 : p[2] };
        });
    }));
  cases.push_back(
    boxCase("flat-layer-on-boundary", "a layer of cells without volume on the boundary",
      []
      {
        return movedPoints(cube(4, 0.0),
          [](const Vec3& p, vtkIdType) {
            return Vec3{ p[0], p[1], p[2] == 0.0 ? 0.25 : p[2] };
          });
      },
      { { 0.0, 0.0, 0.25 }, { 1.0, 1.0, 1.0 } }));
  cases.push_back(boxCase("all-flat", "every cell without volume: a sheet",
    [] {
      return movedPoints(cube(), [](const Vec3& p, vtkIdType) { return Vec3{ p[0], p[1], 0.5 }; });
    },
    { { 0.0, 0.0, 0.5 }, { 1.0, 1.0, 0.5 } }));
  cases.push_back(
    cellCase("points-on-grid-lines", "points moved onto each other's planes and lines",
      []
      {
        return movedPoints(jitteredLattice(5, 0.45, 3, sineField()),
          [](const Vec3& p, vtkIdType) {
            return Vec3{ 0.5 * std::round(2.0 * p[0]), p[1], 0.5 * std::round(2.0 * p[2]) };
          });
      }));
  cases.push_back(boxCase("edges-of-length-0", "every third inner point on its neighbour along x",
    []
    {
      const Grid grid = cube(4, 0.0);
      return movedPoints(grid,
        [](const Vec3& p, vtkIdType)
        {
          const bool moves = p[0] == 0.5 && p[1] > 0.0 && p[1] < 1.0 && p[2] > 0.0 && p[2] < 1.0;
          return Vec3{ moves ? 0.25 : p[0], p[1], p[2] };
        });
    }));
}

void addTurnedCells(HardCases& cases)
{
  const auto reversed = [](int stride)
  {
    const Grid grid = cube();
    std::vector<Ids> tets = tetsOf(grid);
    for (std::size_t t = 0; t < tets.size(); t += static_cast<std::size_t>(stride))
    {
      std::swap(tets[t][0], tets[t][1]);
    }
    return withTets(grid, tets);
  };
  cases.push_back(boxCase("order-reversed-all",
    "all cells with their points in the order of a negative volume", [=] { return reversed(1); }));
  cases.push_back(
    boxCase("order-reversed-half", "every second cell likewise", [=] { return reversed(2); }));
  cases.push_back(cellCase("tangled-inside", "points moved so far that cells turn inside out",
    [] { return jitteredLattice(4, 0.6, 1, sineField()); }));
  cases.push_back(cellCase("tangled-everywhere", "points moved beyond several neighbours",
    [] { return jitteredLattice(4, 1.5, 1, sineField()); }));
  cases.push_back(cellCase("tangled-boundary", "points of one side pushed behind the next layers",
    []
    {
      return movedPoints(jitteredLattice(4, 0.1, 1, sineField()),
        [](const Vec3& p, vtkIdType i) {
          return Vec3{ p[0] > 0.99 && i % 3 == 0 ? p[0] - 0.4 : p[0], p[1], p[2] };
        });
    }));
}

void addRepeatedThings(HardCases& cases)
{
  cases.push_back(boxCase("points-repeated", "cells that name a point twice, beside the sound ones",
    []
    {
      const Grid grid = cube();
      std::vector<Ids> tets = tetsOf(grid);
      const std::size_t sound = tets.size();
      for (std::size_t t = 0; t < sound; t += 3)
      {
        Ids broken = tets[t];
        broken[t % 4] = broken[(t + 1) % 4];
        tets.push_back(broken);
      }
      return withTets(grid, tets);
    }));
  cases.push_back(boxCase("cells-twice", "every cell twice, the second time in another order",
    []
    {
      const Grid grid = cube();
      std::vector<Ids> tets = tetsOf(grid);
      const std::size_t sound = tets.size();
      for (std::size_t t = 0; t < sound; ++t)
      {
        tets.push_back({ tets[t][2], tets[t][0], tets[t][3], tets[t][1] });
      }
      return withTets(grid, tets);
    }));
  cases.push_back(boxCase("mesh-twice", "the whole mesh twice, with points of its own each time",
    [] { return joined(cube(), cube()); }));
  cases.push_back(boxCase("soup", "no cell shares a point with another",
    []
    {
      const Grid grid = cube();
      GridBuilder builder;
      for (const Ids& tet : tetsOf(grid))
      {
        Ids own;
        for (const vtkIdType id : tet)
        {
          Vec3 p;
          grid->GetPoint(id, p.data());
          own.push_back(builder.addPoint(p));
        }
        builder.addCell(10, own);
      }
      return builder.finish(sineField());
    }));
}

void addGluedMeshes(HardCases& cases)
{
  const auto glued = [](double begin, int n)
  {
    return joined(cube(4, 0.0),
      withOffsetAndScale(jitteredLattice(n, 0.0, 5, sineField()), { begin, 0.0, 0.0 }, 1.0));
  };
  const Box two{ { 0.0, 0.0, 0.0 }, { 2.0, 1.0, 1.0 } };
  cases.push_back(boxCase(
    "glued-exactly", "two meshes side by side without common points", [=] { return glued(1.0, 4); },
    two));
  cases.push_back(boxCase(
    "glued-with-gap", "the same with a gap of one unit in the last place",
    [=] { return glued(std::nextafter(1.0, 2.0), 4); }, two));
  cases.back().Known = Answer::Union; // a ray may pass through the gap
  cases.push_back(boxCase(
    "glued-with-gap-of-float", "the same with a gap of one unit in the last place of a float",
    [=] { return glued(double(std::nextafter(1.0f, 2.0f)), 4); }, two));
  cases.back().Known = Answer::Union; // a ray may pass through the gap
  cases.push_back(boxCase(
    "glued-with-overlap", "the same with an overlap of such a unit",
    [=] { return glued(double(std::nextafter(1.0f, 0.0f)), 4); }, two));
  cases.push_back(boxCase(
    "hanging-nodes", "a coarse and a fine mesh meet in a face", [=] { return glued(1.0, 7); },
    two));
}

void addSharedFaces(HardCases& cases)
{
  cases.push_back(cellCase("three-owners", "a face of three tetrahedra, two on one side",
    [] { return tetsOnOneFace(2, 1); }));
  cases.push_back(cellCase("many-owners", "a face of nine tetrahedra, five on one side",
    [] { return tetsOnOneFace(5, 4); }));
  cases.push_back(cellCase("one-sided-face", "a face of three tetrahedra on one side",
    [] { return tetsOnOneFace(3, 0); }));
  cases.push_back(cellCase("moebius-ring",
    "a ring of cells that closes with left and right exchanged", [] { return moebiusRing(24); }));
  cases.push_back(cellCase("moebius-ring-short", "the same of five prisms, so that much overlaps",
    [] { return moebiusRing(5); }));
  cases.push_back(cellCase(
    "defects", "duplicate, flat, degenerate and surplus cells", [] { return defectiveTets(); }));
  cases.push_back(cellCase("one-tet", "one tetrahedron", [] { return singleTet(); }));
  cases.push_back(
    cellCase("two-at-an-edge", "two that share an edge", [] { return twoTetsSharingEdge(); }));
  cases.push_back(
    cellCase("two-at-a-vertex", "two that share a vertex", [] { return twoTetsSharingVertex(); }));
  cases.push_back(boxCase("warped-cells", "hexahedra, wedges, pyramids with bent faces",
    [] { return mixedCells(4, 1, 0.2, sineField()); }));
  cases.back().Known = Answer::Union; // the surface of the cube is bent as well
}
} // namespace

void addCellCases(HardCases& cases)
{
  addSlivers(cases);
  addFlatCells(cases);
  addTurnedCells(cases);
  addRepeatedThings(cases);
  addGluedMeshes(cases);
  addSharedFaces(cases);
}
} // namespace tetmarch::testing
