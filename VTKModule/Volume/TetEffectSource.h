// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh with its scalars as the effects of light and gradients see it.
#ifndef TetMarchVolumeTetEffectSource_h
#define TetMarchVolumeTetEffectSource_h

#include "Light/EffectSource.h"
#include "Mesh/TetMesh.h"

namespace tetmarch
{

class Group;

/** Refers to what it is given. */
class TetEffectSource : public EffectSource
{
public:
  /** cellScalars: one a tetrahedron, or empty if the vertices have scalars. The first word of the
   * version is that of the geometry. */
  TetEffectSource(const TetMesh& mesh, const std::vector<float>& cellScalars,
    const ScalarRange& range, const Fingerprint& version)
    : Mesh(mesh)
    , CellScalars(cellScalars)
    , Range(range)
    , Version(version)
  {
  }

  const VolumeFrame& frame() const override { return this->Mesh.Frame; }
  const ScalarRange& range() const override { return this->Range; }
  Fingerprint geometryVersion() const override { return { this->Version.front() }; }
  /** Other processes have pieces of the mesh. Gradients are then found by all of them or by none:
   * the generation changes in all if the mesh or the scalars of one have changed. */
  void setGroup(Group* group, std::uintptr_t generation)
  {
    this->Processes = group;
    this->Generation = generation;
  }

  Fingerprint scalarsVersion() const override
  {
    Fingerprint version = this->Version;
    version.push_back(this->Generation);
    return version;
  }
  Fingerprint startsVersion() const override
  {
    // The hierarchy renumbers boundary faces.
    return { this->Version.front(), this->Mesh.hasHierarchy() ? std::uintptr_t(1) : 0 };
  }
  bool hasCellGradients() const override { return this->CellScalars.empty(); }
  std::vector<std::array<float, 3>> gradients(bool ofCells) const override;
  double steepestOf(double own) const override;
  std::vector<VertexStart> vertexStarts() const override;
  bool startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const override;

private:
  const TetMesh& Mesh;
  const std::vector<float>& CellScalars;
  const ScalarRange& Range;
  const Fingerprint& Version;
  Group* Processes = nullptr;
  std::uintptr_t Generation = 0;
};

} // namespace tetmarch

#endif
