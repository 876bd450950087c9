// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays begin if the eye is in a mesh: they enter the tetrahedra around it. So they cross no
// cells behind it, and those behind a gap are found by lists.
#ifndef TetMarchEntriesEyeStart_h
#define TetMarchEntriesEyeStart_h

#include "Caching/Fingerprint.h"
#include "Entries/TetsAtPoint.h"
#include "Entries/VisiblePart.h"

#include <functional>

namespace tetmarch
{

/** The faces between the tetrahedra of a part that are around the eye, and all others: each pixel's
 * ray enters through one of them, unless the eye is outside of the part. */
struct EyeStart
{
  std::vector<std::size_t> OfPart;       // those that are faces of the part: indices
  std::vector<std::array<Id, 4>> Inside; // the other ones; as VisiblePart::Faces
  std::vector<Id> Links;                 // of their half-faces
};

/** The most faces of EyeStart::Inside, which all rays test: more than an eye at a vertex of 40
 * tetrahedra needs. */
constexpr std::size_t MostEyeFaces = 64;

/** +1 or -1 for outwardFace() of a tetrahedron. */
using SignOfTet = std::function<int(Id tet)>;

/** Finds the start for one eye after the other. */
class EyeStartFinder
{
public:
  /** visible: null if rays enter all of the mesh. version: of the mesh in its first word, the order
   * of its boundary faces and the part. After an exception there is no start. */
  void update(const TetMesh& mesh, const VisiblePart* visible, const Fingerprint& version,
    const Vector3& eye, const SignOfTet& signOf);
  /** The eye is no longer in the mesh. */
  void leave();

  /** Whether there is a start, for an eye that few tetrahedra surround. */
  bool isFound() const { return this->Found; }
  const EyeStart& start() const { return this->Start; }
  /** All of the mesh, as if it were a part; empty if a visible part was given. */
  const VisiblePart& whole() const { return this->Whole; }
  /** The version of what it was made of. */
  const Fingerprint& wholeVersion() const { return this->WholeVersion; }

private:
  Fingerprint BoxesVersion;
  TetsAtPoint Boxes;
  Fingerprint WholeVersion;
  VisiblePart Whole;
  Fingerprint Version;
  EyeStart Start;
  bool Found = false;
};

} // namespace tetmarch

#endif
