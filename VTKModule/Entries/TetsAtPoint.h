// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra around a point, such as the eye.
#ifndef TetMarchEntriesTetsAtPoint_h
#define TetMarchEntriesTetsAtPoint_h

#include "Mesh/TetMesh.h"

#include <array>
#include <limits>
#include <vector>

namespace tetmarch
{

/** Boxes of clusters of tetrahedra, which are neighbours along the space-filling curve. */
class TetsAtPoint
{
public:
  TetsAtPoint() = default;
  /** Parallel, in a pass over the tetrahedra. */
  explicit TetsAtPoint(const TetMesh& mesh);

  /** The tetrahedra of the mesh that are not farther from a point of the normalised frame than the
   * margin, ascending, and perhaps some that are a little farther from it; not those that no ray
   * crosses. */
  std::vector<Id> find(const TetMesh& mesh, const Vector3& point, double margin) const;

private:
  struct Box
  {
    void add(const Vertex& v);
    bool contains(const Vector3& point, double margin) const;

    std::array<float, 3> Low{ { Largest, Largest, Largest } };
    std::array<float, 3> High{ { -Largest, -Largest, -Largest } };
  };

  static constexpr float Largest = std::numeric_limits<float>::max();

  std::vector<Box> Boxes; // of clusters
};

} // namespace tetmarch

#endif
