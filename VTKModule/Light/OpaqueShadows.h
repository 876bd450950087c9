// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows that opaque surfaces cast into the volume.
#ifndef TetMarchLightOpaqueShadows_h
#define TetMarchLightOpaqueShadows_h

#include "Caching/Fingerprint.h"
#include "Light/LightUniforms.h"
#include "Light/OpaqueSurfaces.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class vtkVolume;

namespace tetmarch
{

struct VolumeFrame;

/** Computed by rays towards the lights of LightUniforms::ShadowSources, in double precision; or on
 * the GPU, by the same triangles. */
class OpaqueShadows
{
public:
  /** Surfaces with unchanged data keep their hierarchies, even if they have moved. */
  void update(const std::vector<OpaqueSurface>& surfaces, vtkVolume* volume,
    const VolumeFrame& frame, const LightUniforms& lights);

  /** Whether a surface is between a point of the normalised frame and a light, at a distance of at
   * least `margin` from the point. Thread-safe. */
  bool isShadowed(const Vector3& point, std::size_t source, double margin = 0) const;

  /** Returns the point of an index, in the normalised frame. False if there is none: no shadow. */
  using PointOf = std::function<bool(std::size_t, Vector3&)>;
  /** For each of `count` points, bit k is 1 if it is in the shadow of light k. Parallel. */
  std::vector<std::uint8_t> ofPoints(std::size_t count, const PointOf& pointOf) const;

  /** The surfaces in single precision, as Shaders/light/opaque_surface_buffers.glsl has them. */
  std::vector<std::array<float, 4>> texels() const;
  /** Changes if texels() do. */
  Fingerprint version() const;
  /** The number of surfaces. */
  std::size_t size() const { return this->Casters.size(); }

  /** The number of hierarchies built so far. */
  int numberOfHierarchies() const { return this->Hierarchies; }

private:
  struct Caster
  {
    Fingerprint Data;
    std::shared_ptr<const TriangleHierarchy> Triangles;
    std::array<double, 16> FromMesh{}; // normalised frame -> coordinates of the data
  };

  std::shared_ptr<const TriangleHierarchy> hierarchyOf(const std::vector<vtkPolyData*>& pieces,
    const Fingerprint& which, const std::vector<Caster>& made);
  std::uint8_t ofPoint(const Vector3& point) const;

  std::vector<Caster> Casters;
  std::vector<std::array<double, 4>> Sources;
  double Reach = 0;
  int Hierarchies = 0;
};

} // namespace tetmarch

#endif
