// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays that meet vertices, edges and faces by construction.
#include "CaseGroup.h"
#include "CaseViews.h"

#include "Grids.h"

#include "vtkMath.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
constexpr int LatticeSize = 8;
constexpr double Spacing = 1.0 / LatticeSize;
constexpr Vec3 Middle = { 0.5, 0.5, 0.5 };

Vec3 normalised(const Vec3& v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  return { v[0] / length, v[1] / length, v[2] / length };
}

struct Direction
{
  const char* Name;
  Vec3 Right;
  Vec3 Up;
  double PixelSpacing;
};

// Down the axes four pixels make an edge of the lattice: every fourth pixel centre of a row is a
// vertex, those with i = j lie on the diagonals of faces. Down (1, 2, 2) all vertices lie on pixel
// centres, since right and up have whole thirds as components. Down the other two diagonals the
// vertices make no square pattern: only the columns lie in lattice planes (x - y constant), and the
// middle row meets vertices.
std::vector<Direction> latticeDirections()
{
  const double third = 1.0 / 3.0;
  return { { "down-x", { 0, 1, 0 }, { 0, 0, 1 }, Spacing / 4.0 },
    { "down-y", { 0, 0, 1 }, { 1, 0, 0 }, Spacing / 4.0 },
    { "down-z", { 1, 0, 0 }, { 0, 1, 0 }, Spacing / 4.0 },
    { "down-110", normalised({ -1, 1, 0 }), { 0, 0, 1 }, Spacing * third / std::sqrt(2.0) },
    { "down-111", normalised({ -1, 1, 0 }), normalised({ -1, -1, 2 }),
      Spacing * third / std::sqrt(2.0) },
    { "down-122", { 2 * third, 1 * third, -2 * third }, { -2 * third, 2 * third, -1 * third },
      Spacing * third } };
}

// The pixel centres of all views pass through the given point.
std::vector<HardView> latticeViews(const Vec3& shiftInPixels)
{
  std::vector<HardView> views;
  for (const Direction& direction : latticeDirections())
  {
    Vec3 through = Middle;
    for (int a = 0; a < 3; ++a)
    {
      through[a] += direction.PixelSpacing *
                    (shiftInPixels[0] * direction.Right[a] + shiftInPixels[1] * direction.Up[a]);
    }
    for (const int pixels : { 64, 65 })
    {
      views.push_back(viewOnPixels(direction.Name + ("-" + std::to_string(pixels)), pixels, through,
        direction.Right, direction.Up, direction.PixelSpacing));
    }
  }
  return views;
}

// The first plane of the lattice is eight edges away, where pixels are a quarter of an edge apart.
// In the j-th plane behind it pixel k meets a vertex wherever (8 + j) k / 32 is whole: every fourth
// one of the first plane, every second one of the last.
std::vector<HardView> fanViews()
{
  std::vector<HardView> views;
  for (const auto& [name, direction, up] :
    { std::tuple<const char*, Vec3, Vec3>{ "along-x", { 1, 0, 0 }, { 0, 0, 1 } },
      { "against-y", { 0, -1, 0 }, { 1, 0, 0 } }, { "along-z", { 0, 0, 1 }, { 0, 1, 0 } } })
  {
    Vec3 eye = Middle;
    for (int a = 0; a < 3; ++a)
    {
      eye[a] -= 1.5 * direction[a];
    }
    const double angle = 2.0 * vtkMath::DegreesFromRadians(std::atan(0.5 * 65 * Spacing / 4.0));
    HardView view = viewFrom(
      name, [eye](vtkUnstructuredGrid*) { return eye; }, direction, up, angle);
    view.Pixels = 65;
    views.push_back(view);
  }
  return views;
}

// Points of the lattice and halves and quarters between them: exact in unjittered lattices.
Vec3 mean(vtkUnstructuredGrid* grid, const Ids& points)
{
  Vec3 sum = { 0.0, 0.0, 0.0 };
  for (const vtkIdType point : points)
  {
    Vec3 p;
    grid->GetPoint(point, p.data());
    for (int a = 0; a < 3; ++a)
    {
      sum[a] += p[a] / static_cast<double>(points.size());
    }
  }
  return sum;
}

// Eyes at a vertex, in the middle of an edge and within a face (twice its first corner, so that
// quarters do), all of the cube (i, j, k).
std::vector<HardView> eyeViews(const std::string& where, int i, int j, int k, const Vec3& direction)
{
  const auto corner = [=](int b)
  {
    return static_cast<vtkIdType>(
      (i + (b & 1)) +
      (LatticeSize + 1) * ((j + (b >> 1 & 1)) + (LatticeSize + 1) * (k + (b >> 2))));
  };
  std::vector<HardView> views;
  for (const auto& [what, points] : { std::pair<const char*, Ids>{ "vertex", { corner(0) } },
         { "edge", { corner(0), corner(2) } }, { "diagonal", { corner(0), corner(6) } },
         { "face", { corner(0), corner(0), corner(2), corner(6) } } })
  {
    views.push_back(viewFrom(
      where + "-" + what,
      [points = points](vtkUnstructuredGrid* grid) { return mean(grid, points); }, direction,
      { 0, 1, 0 }, 75.0));
  }
  return views;
}

// The cube (3, 4, 3) is well inside; face x = 0 of the cube (0, 4, 3) is on the boundary.
std::vector<HardView> eyesInMesh()
{
  const Vec3 oblique = { 0.6, 0.3, 0.7 };
  std::vector<HardView> views = eyeViews("inside", 3, 4, 3, oblique);
  const auto append = [&views](const std::vector<HardView>& more)
  { views.insert(views.end(), more.begin(), more.end()); };
  append(eyeViews("boundary", 0, 4, 3, oblique));
  append(eyeViews("corner", 0, 0, 0, oblique));
  append(eyeViews("along-faces", 3, 4, 3, { 1, 0, 0 }));
  append(eyeViews("out-of-boundary", 0, 4, 3, { -0.6, 0.3, 0.7 }));
  return views;
}

// Columns of prisms along z: where the points of a layer lie in x and y is the same in all layers.
Grid columnsAlongZ()
{
  const Grid lattice = jitteredLattice(LatticeSize, 0.0);
  std::mt19937 generator(1);
  std::vector<double> moves;
  for (int i = 0; i < 2 * (LatticeSize + 1) * (LatticeSize + 1); ++i)
  {
    moves.push_back((static_cast<int>(generator() % 3) - 1) * Spacing / 8.0);
  }
  const Grid grid = mapped(lattice,
    [&](Vec3 p, vtkIdType id)
    {
      const auto column = static_cast<std::size_t>(id) % (moves.size() / 2);
      for (int a = 0; a < 2; ++a)
      {
        p[a] += p[a] > 0.0 && p[a] < 1.0 ? moves[2 * column + a] : 0.0;
      }
      return p;
    });
  attachFields(grid, linearField());
  return grid;
}
} // namespace

void addRayCases(std::vector<HardCase>& cases)
{
  CaseGroup group(cases, "rays");
  const auto lattice = [] { return jitteredLattice(LatticeSize, 0.0); };

  fills(group.add("pixels-on-vertices",
          "plain lattice seen exactly down axes and diagonals; pixel centres are lattice points",
          lattice))
    .Views = latticeViews({ 0.0, 0.0, 0.0 });
  fills(group.add("pixels-on-edges",
          "the same with pixels half a pixel aside: rays in lattice planes that miss all vertices",
          lattice))
    .Views = latticeViews({ 0.0, 0.5, 0.0 });
  fills(group.add("pixels-in-cells", "the same with pixels aside in both directions", lattice))
    .Views = latticeViews({ 0.25, 0.5, 0.0 });
  // A ray in a face sees either side, in each cube anew. Down (1, 1, 1) these are too many choices.
  HardCase& jumps = fills(group.add("jumps",
    "eight cubes, pixels on vertices; each tetrahedron has values of its own: jumps at all faces",
    [] { return withJumps(jitteredLattice(2, 0.0), 0.5); }));
  for (const HardView& view : latticeViews({ 0.0, 0.0, 0.0 }))
  {
    if (view.Name.find("down-111") != 0)
    {
      jumps.Views.push_back(view);
    }
  }
  fills(group.add("fan-through-vertices",
          "plain lattice in a perspective whose rays go through vertices", lattice))
    .Views = fanViews();
  fills(group.add("camera-in-lattice",
          "the eye exactly on a vertex, on edges, in a face, inside and on the boundary", lattice))
    .Views = eyesInMesh();
  fills(group.add("camera-in-jittered-lattice",
          "the eye on a vertex and, up to rounding, on edges and in faces of a jittered lattice",
          [] { return jitteredLattice(LatticeSize); }))
    .Views = eyesInMesh();
  fills(group.add("rays-parallel-to-faces",
          "columns of prisms along z, seen along z: a third of all faces edge-on", columnsAlongZ))
    .Views = { viewOnPixels("down-z-64", 64, Middle, { 1, 0, 0 }, { 0, 1, 0 }, Spacing / 8.0),
    viewOnPixels("down-z-65", 65, Middle, { 1, 0, 0 }, { 0, 1, 0 }, Spacing / 8.0),
    parallelView("down-z", { 0, 0, -1 }, { 0.3, 1, 0 }, 0.8),
    parallelView("in-plane", { 0, 1, -1 }, { 1, 0, 0 }, 0.9) };
}
} // namespace tetmarch::testing
