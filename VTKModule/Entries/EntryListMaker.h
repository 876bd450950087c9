// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes the lists of EntryLists.h for one view after the other, within the texture buffer size of
// the GL.
#ifndef TetMarchEntriesEntryListMaker_h
#define TetMarchEntriesEntryListMaker_h

#include "Entries/EntryLists.h"
#include "Entries/EyeStart.h"
#include "Entries/Footprint.h"

#include <atomic>
#include <optional>

namespace tetmarch
{

/** It keeps its memory for the next view: new memory takes as long as the lists. */
class EntryListMaker
{
public:
  /** As makeEntryLists(), but tiles are enlarged until neither array has more than mostTexels
   * elements, if there are no more faces than that. Those inside of the start have the indices
   * behind the faces of the part. The lists stay until the next call. */
  const EntryLists& make(std::uint64_t mostTexels, const TetMesh& mesh,
    const std::vector<std::array<Id, 4>>& faces, const View& view, int width, int height,
    const EyeStart& start = {});

private:
  // A candidate of a tile, and its place among those of the tile.
  struct FoundCandidate
  {
    std::uint32_t Tile;
    std::uint32_t Place;
    EntryCandidate Candidate;
  };

  int tilesAlong(int pixels) const;
  std::uint64_t numberOfTiles() const;
  std::uint64_t mostCandidates() const;
  bool fits(std::uint64_t mostTiles, std::uint64_t mostCandidates) const;
  FaceCorners cornersOf(std::size_t face) const;
  void findFootprints();
  void coverPicture(std::size_t face);
  void findFootprintsOf(std::size_t batch);
  void chooseTiles(std::uint64_t mostTexels);
  template <typename Visit>
  void visitTiles(std::size_t face, const Visit& visit) const;
  void findCandidates();
  void findCandidatesOf(std::size_t chunk);
  void sortCandidates();

  std::optional<FaceProjection> Projection;
  const Vertex* Vertices = nullptr;
  const std::vector<std::array<Id, 4>>* Faces = nullptr;
  const EyeStart* Start = nullptr;
  int Width = 0;
  int Height = 0;
  std::vector<Footprint> Footprints;
  std::vector<std::vector<FoundCandidate>> Found; // of each chunk of faces
  std::vector<std::atomic<std::uint32_t>> Counts; // of the candidates of each tile
  EntryLists Lists;
};

} // namespace tetmarch

#endif
