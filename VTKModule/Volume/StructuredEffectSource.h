// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A structured volume as the effects of light and gradients see it. The march takes gradients from
// the values; light is kept at nodes of a coarser lattice in place of vertices.
#ifndef TetMarchVolumeStructuredEffectSource_h
#define TetMarchVolumeStructuredEffectSource_h

#include "Light/EffectSource.h"
#include "Structured/StructuredVolume.h"

namespace tetmarch
{

/** Refers to what it is given. */
class StructuredEffectSource : public EffectSource
{
public:
  explicit StructuredEffectSource(const StructuredVolume& volume)
    : Source(volume)
  {
  }

  const VolumeFrame& frame() const override { return this->Source.frame(); }
  const ScalarRange& range() const override { return this->Source.values().front().Range; }
  Fingerprint geometryVersion() const override { return this->Source.latticeVersion(); }
  Fingerprint scalarsVersion() const override { return this->Source.valuesVersion(); }
  bool storesGradients() const override { return false; }
  bool hasCellGradients() const override { return !this->Source.lattice().Constant; }
  std::vector<std::array<float, 3>> gradients(bool) const override { return {}; }
  /** The numbers of the nodes along the axes. */
  std::vector<VertexStart> vertexStarts() const override;
  bool startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const override;

private:
  const StructuredVolume& Source;
};

} // namespace tetmarch

#endif
