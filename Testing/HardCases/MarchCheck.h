// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Send rays through a hard case and hold each against what it must be
 *
 * Each ray is marched in float, as on the GPU: in every second chunk with the fused predicate, in
 * every second one with the portable one.
 *
 * The bound of its length. With positions of at most 1 in the normalised frame and a ray's origin
 * of at most 1, a projected coordinate is a difference (error 2^-24) times a unit vector, summed
 * over three axes (2^-22), and the portable form rounds it to 2^-23: together under 2^-21. For the
 * projected bits signs are exact, and weights to an ulp or two. So what float marches is, up to the
 * rounding of the sum, the exact answer for vertices displaced by that much, and the length must
 * lie between the least and the greatest length that a ray sees while vertices move within that
 * distance. The sum itself adds 2^-24 of the length a cell.
 *
 * Where the cells fill a box, these are the chords of the box made smaller and greater, for every
 * ray. Elsewhere, and where surfaces meet inside of the box, the same ray (the same bits of origin
 * and direction) is marched in double; if that differs by more than the rounding of the sum, the
 * bound is sampled in double: the ray moved aside, in copies of the mesh with displaced vertices.
 * Double in turn is held against brute force, which knows nothing of faces, links and order.
 *
 * In cases about optics the transfer functions of the case are integrated instead, and colour and
 * transmittance have to be finite and within 0..1; that they are right is for PictureCheck.h.
 */
#ifndef tetmarch_testing_MarchCheck_h
#define tetmarch_testing_MarchCheck_h

#include "HardCase.h"

#include "Mesh/Scalars.h"
#include "Mesh/TetMesh.h"
#include "Optics/IntegralTable.h"

#include <cstdint>
#include <memory>
#include <string>

namespace tetmarch::testing
{
class OracleScene;

/// Sums over rays. All but Rays, Met, Compared and the worst are failures.
struct RayTotals
{
  std::int64_t Rays = 0;
  std::int64_t Met = 0;      ///< met the mesh
  std::int64_t Compared = 0; ///< with brute force or the box
  std::int64_t Lost = 0;
  std::int64_t Guarded = 0;
  std::int64_t Refused = 0;
  std::int64_t NotFinite = 0;    ///< NaN, infinite or not in 0..1
  std::int64_t Negative = 0;     ///< a length below 0
  std::int64_t OutOfBound = 0;   ///< float against double
  std::int64_t NotTheAnswer = 0; ///< float against the box, double against brute force
  double WorstError = 0.0;       ///< of a length, in mesh radii, against the box or double
  double WorstGeneric = 0.0;     ///< the same for rays without any tie or grazing by construction
  std::string FirstFailure;      ///< the ray of it

  std::int64_t failures() const;
  RayTotals& operator+=(const RayTotals& other);
};

/// A case ready to be marched: mesh with hierarchy, scalars, table.
class MarchCheck
{
public:
  /// Throws std::runtime_error if the mesh can't be built.
  explicit MarchCheck(const HardCase& hard);
  ~MarchCheck();

  /// The rays of one chunk, always the same ones; may be called from several threads.
  RayTotals run(unsigned chunk, int rays) const;

  const TetMesh& mesh() const { return this->Mesh; }

private:
  template <typename Kernel>
  class Lengths;
  template <typename Kernel>
  class Colours;

  const HardCase& Case;
  TetMesh Mesh;
  std::vector<float> CellScalars;
  ScalarRange Range;
  IntegralTable Table;
  double UnitDistance = 1.0; // in mesh radii
  Box NormalizedBox{};
  std::vector<TetMesh> Displaced; // copies with other positions
  std::unique_ptr<OracleScene> BruteForce;
};
} // namespace tetmarch::testing

#endif
