// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the visible part of a mesh, and again after each edit of what is shown: only tetrahedra
// whose visibility may have changed, and their neighbours, are looked at.
#ifndef TetMarchEntriesVisiblePartFinder_h
#define TetMarchEntriesVisiblePartFinder_h

#include "Caching/Fingerprint.h"
#include "Entries/SeenTets.h"

#include <atomic>
#include <optional>

namespace tetmarch
{

class VisiblePartFinder
{
public:
  /** Whether part() is what update() would find. */
  bool isCurrent(const VisibleScalars& shown, const Fingerprint& version) const;
  /** version: of the mesh, in its first word, its scalars and the hidden cells. After an exception
   * the part is of no use until the next call. */
  void update(const TetMesh& mesh, const VisibleScalars& shown, const Fingerprint& version);
  /** See linkVisiblePart(). */
  void link(const TetMesh& mesh) { linkVisiblePart(mesh, this->Part); }
  /** +1 or -1 for outwardFace() of a tetrahedron of the mesh of update(). It may take as long as
   * that, once a mesh. */
  int outsideSign(const TetMesh& mesh, Id tet);
  /** Forget everything: nothing is known of what is visible. */
  void clear();

  const VisiblePart& part() const { return this->Part; }
  VisiblePart takePart() { return std::move(this->Part); }

private:
  using Ends = std::vector<std::size_t>;
  using Faces = std::vector<std::array<Id, 4>>;
  void begin(const TetMesh& mesh, const MeshScalars& scalars, bool isSameMesh);
  void mark(const TetMesh& mesh, const VisibleScalars& shown);
  std::uint32_t degenerateIn(std::size_t word) const
  {
    return this->DegenerateTets.empty() ? 0 : this->DegenerateTets[word];
  }
  const std::vector<std::int8_t>& allSigns(const TetMesh& mesh);
  void findEntries(const TetMesh& mesh);
  void findEntriesOf(const TetMesh& mesh, std::size_t tet);
  void toggle(std::size_t halfFace, std::uint32_t bits);
  void findFaces(const TetMesh& mesh);
  Ends endsOfChunks() const;
  bool makeFaces(const TetMesh& mesh, bool byVolumes);
  template <typename Visit>
  void visitEntries(std::size_t begin, std::size_t end, const Visit& visit) const;

  Fingerprint Version;          // empty: nothing is known
  std::optional<SeenTets> Seen; // by which the part was found
  TetLevels Levels;
  /** One bit for each half-face: 1 if its tetrahedron is visible, and none behind it; the visible
   * ones for which it is known. */
  std::vector<std::atomic<std::uint32_t>> Entries;
  std::vector<std::uint32_t> KnownTets;
  /** A bit for each tetrahedron; empty if none is degenerate. Rays pass through them from one
   * visible tetrahedron to another. */
  std::vector<std::uint32_t> DegenerateTets;
  Ends Chunks;                    // where the faces of each chunk of Entries end
  Faces LastFaces;                // of the last part; kept, since new memory takes long
  bool ByVolumes = false;         // volumes determine how faces are oriented; else Signs
  std::vector<std::int8_t> Signs; // outsideSigns(), if they were needed
  VisiblePart Part;
};

} // namespace tetmarch

#endif
