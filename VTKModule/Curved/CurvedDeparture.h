// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How far tetrahedra are from the curved cell that was cut into them.
#ifndef TetMarchCurvedCurvedDeparture_h
#define TetMarchCurvedCurvedDeparture_h

#include "Curved/CellPieces.h"
#include "Curved/OutputPoints.h"
#include "Geometry/Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** At most. */
struct CurvedDeparture
{
  /** From faces to those of curved cells, in units of coordinates. */
  double Distance = 0;
  /** Of scalars at one place; of several components as vectors, or of their magnitudes. */
  double Value = 0;
};
inline bool isAny(const CurvedDeparture& departure)
{
  return departure.Distance > 0 || departure.Value > 0;
}

/** A point of a curved edge beside that of the straight edge with equal parametric coordinates. */
struct EdgeDeparture
{
  Vector3 Apart{};
  std::vector<double> Values; // the differences of components
  double Magnitude = 0;       // the difference of magnitudes
};

/** Those of edges, numbered. */
class EdgeDepartures
{
public:
  std::uint32_t add(const EdgeDeparture& departure);
  Vector3 apart(std::uint32_t edge) const;
  /** Of a component; behind the last one, of magnitudes. */
  double value(std::uint32_t edge, std::size_t component) const
  {
    return this->Values[edge * (this->Components + 1) + component];
  }
  std::size_t components() const { return this->Components; }

private:
  std::vector<float> Places;
  std::vector<float> Values;
  std::size_t Components = 0;
};

/**
 * Of a tetrahedron with these edges (PieceEdges). In a cell of quadratic functions, the place with
 * barycentric coordinates l is off by the sum of 4 l_i l_j d_ij over the edges, d_ij being that of
 * the edge's middle, and so is the scalar there. The linear scalar, continued to this place, is off
 * by the sum of 4 l_i l_j (v_ij - d_ij . gradient), at most 3/2 of the greatest of these; a face by
 * at most 4/3 of the greatest distance of its edges from its plane.
 */
CurvedDeparture departureOf(const Piece& piece, const std::array<std::uint32_t, 6>& edges,
  const EdgeDepartures& departures, const OutputPoints& points);

} // namespace tetmarch

#endif
