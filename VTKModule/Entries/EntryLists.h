// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces through which the rays of a picture may enter a mesh, in lists per tile of pixels: a
// ray tests only those of its tile, front to back (Shaders/tet/entry_lists.glsl). The exact
// predicate decides there through which face it enters. A list may contain faces through which no
// ray of the tile enters, but it lacks none.
#ifndef TetMarchEntriesEntryLists_h
#define TetMarchEntriesEntryLists_h

#include "Mesh/TetMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

struct View;

/** A face through which rays may enter, and its pixels in a tile; one texel on the GPU. */
struct EntryCandidate
{
  std::uint32_t Face;
  /** Bits 16 to 31: lower bound of the face's depth. Bits 0 to 15, four each: the pixels, or
   * squares of pixels, whose rays may enter through it, from the tile's lower left: first and last
   * in x, first and last in y. */
  std::uint32_t Where;
};

struct EntryLists
{
  int TileShift = 0; // tiles are squares with an edge of 2^TileShift pixels
  int TilesPerRow = 0;
  std::array<float, 4> DepthPlane{}; // (x, y, z, 1) . plane is the depth of a point of the mesh
                                     // in the units of Where; it grows along each ray
  std::vector<std::uint32_t>
    First; // index of the first candidate of each tile, row by row, and the end
  std::vector<EntryCandidate> Candidates; // those of each tile by ascending depth
};

/** Tiles larger than 16 x 16 pixels have a resolution of a 16th of their edge. */
constexpr int MostEntryTileShift = 4;

/**
 * The lists of a picture of width x height pixels, by indices of faces; each face begins with three
 * vertices of the mesh, counter-clockwise seen from outside. The eye must not lie in the mesh:
 * there rays begin at an EyeStart (EntryListMaker). Parallel, in time proportional to the numbers
 * of faces and candidates.
 */
EntryLists makeEntryLists(const TetMesh& mesh, const std::vector<std::array<Id, 4>>& faces,
  const View& view, int width, int height);

} // namespace tetmarch

#endif
