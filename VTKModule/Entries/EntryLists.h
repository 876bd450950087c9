// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces by which the rays of a picture may enter a mesh, in lists by tiles of pixels: a ray
// tests those of its tile, front to back, instead of searching all of them
// (Shaders/tet/entry_lists.glsl). Which one it enters by is decided there, by the exact predicate.
// A list may hold faces that no ray of the tile enters by, but it lacks none.
#ifndef TetMarchEntriesEntryLists_h
#define TetMarchEntriesEntryLists_h

#include "Mesh/TetMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

struct View;

/** A face by which rays may enter, and for which pixels of a tile; one texel on the GPU. */
struct EntryCandidate
{
  std::uint32_t Face;
  /** Bits 16 to 31: no point of the face is nearer than this depth. Bits 0 to 15, four each: the
   * pixels, or squares of pixels, whose rays may enter by it, from the tile's lower left: first and
   * last in x, first and last in y. */
  std::uint32_t Where;
};

struct EntryLists
{
  int TileShift = 0; // tiles are squares with an edge of 2^TileShift pixels
  int TilesPerRow = 0;
  std::array<float, 4> DepthPlane{}; // (x, y, z, 1) . plane is the depth of a point of the mesh
                                     // in the units of Where; it grows along each ray
  std::vector<std::uint32_t> First;  // the first candidate of each tile, row by row, and the end
  std::vector<EntryCandidate> Candidates; // those of each tile by ascending depth
};

/** Larger tiles, of more than 16 x 16 pixels, tell apart squares of a 16th of their edge. */
constexpr int MostEntryTileShift = 4;

/**
 * The lists of a picture of width x height pixels, of faces by number; each begins with three
 * vertices of the mesh, counter-clockwise seen from where rays come. All of the mesh lies before
 * the eye (not View::CutsNearPlane). In parallel, in time proportional to the faces and to the
 * candidates.
 */
EntryLists makeEntryLists(const TetMesh& mesh, const std::vector<std::array<Id, 4>>& faces,
  const View& view, int width, int height);

} // namespace tetmarch

#endif
