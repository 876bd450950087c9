// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which boxes of a structured grid a line meets, and where: brute force, each box clipped
 * against the line
 *
 * Has nothing in common with the marching renderer on purpose: no steps from cell to cell, no
 * normalised frame, no numbers that are stored.
 */
#ifndef tetmarch_testing_LatticeChords_h
#define tetmarch_testing_LatticeChords_h

#include "RayChords.h"

#include <initializer_list>

class vtkDataSet;
class vtkImageData;
class vtkRectilinearGrid;

namespace tetmarch::testing
{
/// Where the values of a structured grid are, and what is between them.
enum class LatticeValues
{
  PointsLinear,  ///< trilinear between points
  PointsNearest, ///< the value of the nearest point; what is equally near counts for either
  CellsLinear,   ///< trilinear between the centres of cells; constant beyond the outer ones
  CellsNearest   ///< the value of the cell
};
constexpr std::initializer_list<LatticeValues> AllLatticeValues = { LatticeValues::PointsLinear,
  LatticeValues::PointsNearest, LatticeValues::CellsLinear, LatticeValues::CellsNearest };

constexpr bool isOfCells(LatticeValues values)
{
  return values == LatticeValues::CellsLinear || values == LatticeValues::CellsNearest;
}
constexpr bool isLinear(LatticeValues values)
{
  return values == LatticeValues::PointsLinear || values == LatticeValues::CellsLinear;
}

/// A part of an axis that is within one cell of the data and on which the value is interpolated
/// between the same two neighbours, or is that of one.
struct LatticeSlab
{
  double Planes[2] = { 0.0, 0.0 }; ///< lower number first, which may be the greater coordinate
  int Cell = 0;                    ///< of the data, from 0
  int Values[2] = { 0, 0 };        ///< numbers of the two values, from 0; equal if constant
  double Places[2] = { 0.0, 1.0 }; ///< where those are
};

/// The part of a line inside one box, by lengths from the line's origin, and the places of its
/// ends: for each axis 0 at the first value and 1 at the second one.
struct LatticeChord
{
  std::array<int, 3> Slabs{};
  double T0 = 0.0;
  double T1 = 0.0;
  std::array<long double, 3> Begin{};
  std::array<long double, 3> End{};
};

class LatticeChords
{
public:
  /// An image or a rectilinear grid. Throws std::invalid_argument if it is something else, or if it
  /// has no volume.
  LatticeChords(vtkDataSet* data, LatticeValues values);

  /// All chords of positive length within [tMin, tMax], sorted by entry; they don't overlap. A line
  /// within a plane between boxes belongs to those of greater indices (images) or coordinates, or
  /// to the last ones.
  std::vector<LatticeChord> find(const Ray& ray, double tMin, double tMax) const;

  const LatticeSlab& slab(int axis, int i) const { return this->Slabs[axis][i]; }
  /// Of the values along an axis.
  int count(int axis) const { return this->Counts[axis]; }
  int cells(int axis) const { return this->Cells[axis]; }

private:
  using Vec3l = std::array<long double, 3>;
  struct Interval
  {
    long double T0;
    long double T1;
  };

  void readImage(vtkImageData* image, LatticeValues values);
  void readRectilinear(vtkRectilinearGrid* grid, LatticeValues values);
  /// By the coordinates of all points along an axis.
  void cutAxis(int axis, const std::vector<double>& points, LatticeValues values);
  std::vector<Interval> intervalsOf(int axis, long double origin, long double direction) const;

  std::vector<LatticeSlab> Slabs[3];
  int Counts[3] = { 0, 0, 0 };
  int Cells[3] = { 0, 0, 0 };
  /// From coordinates of the data to those of slabs: rows (x - Origin).
  Vec3l Origin{};
  std::array<Vec3l, 3> Rows{};
};
} // namespace tetmarch::testing

#endif
