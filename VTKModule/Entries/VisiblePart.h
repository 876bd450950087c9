// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra that may be visible. Rays enter and leave only these, and skip transparent
// tetrahedra.
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
  /** One bit per tetrahedron, as in HiddenCells: 1 if it may be visible. */
  std::vector<std::uint32_t> Tets;
  std::size_t NumberOfTets = 0; // that have the bit
  /** The faces between a visible tetrahedron and another one, or the outside: three vertices,
   * counter-clockwise seen from there, and the half-face inside. */
  std::vector<std::array<Id, 4>> Faces;
  std::vector<Id> Links; // of those half-faces
  /** Estimated number of transparent tetrahedra on a ray between two visible parts. */
  double CellsOfGap = 0;
};

/** The inputs that determine which tetrahedra are visible. */
struct VisibleScalars
{
  const MeshScalars* Scalars = nullptr;
  const IntegralTable* Table = nullptr; // of the first scalar, which is that of the opacity
  const Blending* Blend = nullptr;      // composite, or surfaces
  const HiddenCells* Hidden = nullptr;
  bool UndrawnSeen = false; // tetrahedra with a scalar that is not finite are visible
};

/** Whether the part was computed and is empty. */
inline bool showsNothing(const VisiblePart& part)
{
  return !part.Tets.empty() && part.NumberOfTets == 0;
}

/** Parallel, in a few passes over the tetrahedra. */
VisiblePart findVisiblePart(const TetMesh& mesh, const VisibleScalars& shown);

/** Update the links after the boundary faces of the mesh were reordered. */
void linkVisiblePart(const TetMesh& mesh, VisiblePart& part);

/** Whether finding the next entry probably takes less time than marching through a gap, or nothing
 * is visible. An entry takes the tests of a few faces; times are in Testing/Benchmark/README.md. */
inline bool isWorthEntering(const VisiblePart& part)
{
  constexpr double leastGap = 5.0; // break-even is 4 to 13 cells, depending on the length of rays
  return showsNothing(part) || part.CellsOfGap >= leastGap;
}

/** The same for a part in use, with a lower threshold: finding entries then takes hardly longer. */
inline bool staysWorthEntering(const VisiblePart& part)
{
  constexpr double leastGap = 3.0;
  return showsNothing(part) || part.CellsOfGap >= leastGap;
}

} // namespace tetmarch

#endif
