// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The interface of a volume for light and gradients.
#ifndef TetMarchLightEffectSource_h
#define TetMarchLightEffectSource_h

#include "Caching/Fingerprint.h"
#include "Geometry/VolumeFrame.h"
#include "Scalars/StoredScalar.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

class Group;

class EffectSource
{
public:
  /** The starting point of a ray from a vertex: see Mesh/VertexStarts.h. */
  using VertexStart = std::array<std::uint32_t, 4>;

  virtual ~EffectSource() = default;

  virtual const VolumeFrame& frame() const = 0;
  /** The range of the first scalar, whose gradients are used. */
  virtual const ScalarRange& range() const = 0;
  /** Equal as long as positions and cells are the same; one word. */
  virtual Fingerprint geometryVersion() const = 0;
  /** Equal as long as the scalars are the same, too. */
  virtual Fingerprint scalarsVersion() const = 0;

  /** Whether gradients are stored; if not, the march computes them from the scalars. */
  virtual bool storesGradients() const { return true; }
  /** Whether the scalar may vary within a cell, so that cells have gradients. */
  virtual bool hasCellGradients() const = 0;
  /** Whether vertices have no gradients, since the scalar jumps between cells. */
  virtual bool needsCellGradients() const { return false; }
  /** Gradients of the stored scalar in the normalised frame: one per cell or per vertex; none if
   * they are not stored. Collective if other processes have pieces of the volume. */
  virtual std::vector<std::array<float, 3>> gradients(bool ofCells, Group* processes) const = 0;

  /** The same of independent components, all of a vertex one after the other. */
  virtual std::vector<std::array<float, 3>> componentGradients(Group*) const { return {}; }

  /** Equal as long as vertexStarts() are the same. */
  virtual Fingerprint startsVersion() const { return this->geometryVersion(); }
  /** Starting points of rays from vertices to the light; empty if no light is stored at vertices.
   */
  virtual std::vector<VertexStart> vertexStarts() const = 0;
  /** The starting point of rays from the vertex, in the normalised frame. False if it has none.
   */
  virtual bool startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const = 0;
};

} // namespace tetmarch

#endif
