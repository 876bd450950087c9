// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The right answer for one ray through an image or a rectilinear grid, by brute force
 *
 * It has neither code nor an idea in common with the marching renderer: every box on which one
 * trilinear interpolant holds is clipped against the line (LatticeChords.h). Along the chord the
 * interpolant is a cubic, which goes through its values at four points (Cubic.h). Of that the
 * integrals are taken by adaptive quadrature of VTK's own functions (SegmentIntegral.h), and its
 * extremes and crossings are found.
 *
 * What is drawn: a cell of the data is hidden if it is marked as hidden, as a duplicate or as
 * refined, or if one of its points is marked as hidden. Not drawn is a box in which a value has a
 * part that is not finite, or that is of a hidden cell, or, if it is alone there, of a point that
 * is hidden or has marked cells alone about it; nor is a hidden cell between points.
 *
 * Rays and lengths are in coordinates of the data.
 */
#ifndef tetmarch_testing_LatticeTruth_h
#define tetmarch_testing_LatticeTruth_h

#include "LatticeChords.h"
#include "SegmentIntegral.h"

#include <optional>

namespace tetmarch::testing
{
/// A part of a ray on which the scalar is a cubic.
struct ScalarSegment
{
  double T0 = 0.0; ///< lengths from the ray's origin
  double T1 = 0.0;
  Cubic Scalar;
};

/// A surface of constant scalar, where a ray meets it.
struct SurfaceCrossing
{
  double T = 0.0;
  double Value = 0.0;
};

class LatticeTruth
{
public:
  static constexpr double Infinity = RayChords::Infinity;

  /// Copies the coordinates and one component of the active scalars, of points or of cells. Throws
  /// std::invalid_argument if there are none, or as LatticeChords does. The nodes of the transfer
  /// functions are read here, their values for each ray: build a new one after an edit.
  LatticeTruth(
    vtkDataSet* data, const OpticalModel& model, LatticeValues values, int component = 0);

  /// What is drawn of a ray between two lengths, front to back.
  std::vector<ScalarSegment> segments(
    const Vec3& origin, const Vec3& direction, double tMin = 0.0, double tMax = Infinity) const;

  /// The length of what is drawn.
  double pathLength(const Vec3& origin, const Vec3& direction, double tMin = -Infinity,
    double tMax = Infinity) const;

  /// Premultiplied RGBA of what the ray sees between two lengths from its origin.
  std::array<double, 4> integrate(
    const Vec3& origin, const Vec3& direction, double tMin = 0.0, double tMax = Infinity) const;

  /// The same from the origin on where each point shines with its colour times a brightness; see
  /// GroundTruthScene.
  std::array<double, 4> integrateLit(const Vec3& origin, const Vec3& direction,
    const std::function<double(const Vec3&)>& brightness, double tolerance) const;

  /// The integral of the extinction over the same part of the ray.
  double depth(
    const Vec3& origin, const Vec3& direction, double tMin = 0.0, double tMax = Infinity) const;

  /// The least and the greatest scalar along the ray, if anything is drawn of it.
  std::optional<std::array<double, 2>> extremes(
    const Vec3& origin, const Vec3& direction, double tMin = 0.0, double tMax = Infinity) const;

  /// Over the part of the ray whose scalar is within [low, high].
  OpacitySums opacitySums(const Vec3& origin, const Vec3& direction, double low = -Infinity,
    double high = Infinity, double tMin = 0.0, double tMax = Infinity) const;

  /// Where the scalar reaches one of the values or falls below it, front to back. A ray that begins
  /// behind a surface does not meet it; nor is there one between two cells of constant values.
  std::vector<SurfaceCrossing> crossings(const Vec3& origin, const Vec3& direction,
    const std::vector<double>& values, double tMin = 0.0, double tMax = Infinity) const;

  /// Premultiplied RGBA of these surfaces, each of the functions' colour and opacity at its value.
  std::array<double, 4> isosurfaces(const Vec3& origin, const Vec3& direction,
    const std::vector<double>& values, double tMin = 0.0, double tMax = Infinity) const;

private:
  void readScalars(vtkDataSet* data, bool ofPoints, int component);
  void readHidden(vtkDataSet* data);
  /// Calls found(cell) with the cells of the data that have the point.
  template <typename Found>
  void forCellsAround(vtkIdType point, const Found& found) const;
  std::optional<Cubic> scalarAlong(const LatticeChord& chord) const;
  SegmentResult march(const Ray& ray, double tMin, double tMax) const;

  LatticeChords Chords;
  SegmentIntegral Optics;
  OpticalModel Model;
  LatticeValues Kind;
  std::vector<double> Scalars;   // not a number where hidden
  std::vector<bool> HiddenCells; // of the data
};
} // namespace tetmarch::testing

#endif
