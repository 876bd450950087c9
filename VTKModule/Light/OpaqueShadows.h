// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows that opaque surfaces cast into the volume.
#ifndef TetMarchLightOpaqueShadows_h
#define TetMarchLightOpaqueShadows_h

#include "Caching/Fingerprint.h"
#include "Light/LightUniforms.h"
#include "Light/OpaqueSurfaces.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkVolume;

namespace tetmarch
{

/** By rays towards the lights of LightUniforms::ShadowSources, in double precision. */
class OpaqueShadows
{
public:
  /** Hierarchies of surfaces whose data is the same as before are kept, wherever these have moved.
   */
  void update(const std::vector<OpaqueSurface>& surfaces, vtkVolume* volume, const TetMesh& mesh,
    const LightUniforms& lights);

  /** Whether a surface stands between a point of the mesh's normalised frame and a light, and not
   * within `margin` of the point. Any number of threads may ask. */
  bool isShadowed(const Vector3& point, std::size_t source, double margin = 0) const;

  /**
   * For each vertex, in bit k whether it lies in the shadow of light k. Like in
   * Shaders/light/vertex_light.glsl a point a little within the tetrahedron of the vertex's start
   * stands for it, so that a vertex on a surface is on the same side as that.
   */
  std::vector<std::uint8_t> ofVertices(
    const TetMesh& mesh, const std::vector<std::array<std::uint32_t, 4>>& starts) const;

  /** Ever. */
  int numberOfHierarchies() const { return this->Hierarchies; }

private:
  struct Caster
  {
    Fingerprint Data;
    std::shared_ptr<const TriangleHierarchy> Triangles;
    std::array<double, 16> FromMesh{}; // normalised frame -> coordinates of the data
  };

  std::shared_ptr<const TriangleHierarchy> hierarchyOf(
    vtkPolyData* data, const Fingerprint& which, const std::vector<Caster>& made);
  std::uint8_t ofVertex(
    const TetMesh& mesh, std::uint32_t vertex, const std::array<std::uint32_t, 4>& start) const;

  std::vector<Caster> Casters;
  std::vector<std::array<double, 4>> Sources;
  double Reach = 0;
  int Hierarchies = 0;
};

} // namespace tetmarch

#endif
