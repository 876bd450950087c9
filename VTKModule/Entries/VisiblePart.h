// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of which something may be seen. Rays enter and leave these alone: what a transfer
// function hides is not marched through.
#ifndef TetMarchEntriesVisiblePart_h
#define TetMarchEntriesVisiblePart_h

#include "Appearance/Blending.h"
#include "Mesh/HiddenCells.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/TetMesh.h"
#include "Optics/IntegralTable.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

struct VisiblePart
{
  /** A bit a tetrahedron, as in HiddenCells: 1 if something may be seen of it. */
  std::vector<std::uint32_t> Tets;
  std::size_t NumberOfTets = 0; // that have the bit
  /** The faces between such a tetrahedron and another one, or the outside: three vertices,
   * counter-clockwise seen from there, and the half-face inside. */
  std::vector<std::array<Id, 4>> Faces;
  std::vector<Id> Links; // of those half-faces
  /** How many tetrahedra between two entries a ray crosses without seeing anything, about. */
  double CellsOfGap = 0;
};

/** What decides which tetrahedra are seen. */
struct VisibleScalars
{
  const MeshScalars* Scalars = nullptr;
  const IntegralTable* Table = nullptr; // of the first scalar, which is that of the opacity
  const Blending* Blend = nullptr;      // composite, or surfaces
  const HiddenCells* Hidden = nullptr;
  bool UndrawnSeen = false; // what touches a scalar that is not finite is seen
};

/** Whether it was found and is nothing. */
inline bool showsNothing(const VisiblePart& part)
{
  return !part.Tets.empty() && part.NumberOfTets == 0;
}

/** In parallel, in a few passes over the tetrahedra. */
VisiblePart findVisiblePart(const TetMesh& mesh, const VisibleScalars& shown);

/** Set the links anew: the boundary faces of the mesh have got other numbers. */
void linkVisiblePart(const TetMesh& mesh, VisiblePart& part);

/** Whether it may take less time to look for the next entry than to march through a gap, or all is
 * one. An entry takes the tests of a few faces; Testing/Benchmark/README.md has times. */
inline bool isWorthEntering(const VisiblePart& part)
{
  constexpr double leastGap = 5.0; // even from 4 to 13 cells on, depending on how far rays come
  return showsNothing(part) || part.CellsOfGap >= leastGap;
}

/** Whether to look for entries takes hardly longer, if rays do so already. */
inline bool staysWorthEntering(const VisiblePart& part)
{
  constexpr double leastGap = 3.0;
  return showsNothing(part) || part.CellsOfGap >= leastGap;
}

} // namespace tetmarch

#endif
