// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which tetrahedra a line meets, and where: brute force, one tetrahedron after the other
 *
 * Has nothing in common with the marching renderer on purpose: no links, no signs of edges, no
 * order of vertices.
 */
#ifndef tetmarch_testing_RayChords_h
#define tetmarch_testing_RayChords_h

#include "GridBuilder.h"

#include <limits>
#include <vector>

namespace tetmarch::testing
{
/// The part of a line inside one tetrahedron, by lengths from the line's origin, and the
/// barycentric coordinates (which need no orientation) of its ends.
struct Chord
{
  vtkIdType Cell = -1;
  double T0 = 0.0;
  double T1 = 0.0;
  std::array<double, 4> W0;
  std::array<double, 4> W1;
};

/// The line of the origin and a direction of any length.
struct Ray
{
  Vec3 Origin;
  Vec3 Direction;
};

class RayChords
{
public:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  /// Throws std::invalid_argument if a cell is no VTK_TETRA.
  explicit RayChords(vtkUnstructuredGrid* grid);

  /// All chords of positive length within [tMin, tMax], sorted by entry. Cells without volume give
  /// none. Clipped against the four planes in long double, in coordinates about the origin of the
  /// ray.
  std::vector<Chord> find(const Ray& ray, double tMin = -Infinity, double tMax = Infinity) const;

  /// Chords shortened so that they don't overlap: each begins where the ones before it end. A ray
  /// within a face of two cells counts once so, and so does space that an inverted cell shares with
  /// its neighbours.
  static std::vector<Chord> withoutOverlap(std::vector<Chord> sorted);

  vtkIdType pointOf(vtkIdType cell, int corner) const { return this->Corners[4 * cell + corner]; }

private:
  Chord clip(vtkIdType cell, const Vec3& origin, const Vec3& unit) const;

  std::vector<Vec3> Points;
  Ids Corners;
  std::vector<std::array<double, 4>> Spheres; // centre and radius about each cell
};
} // namespace tetmarch::testing

#endif
