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

/** Found by rays towards the lights of LightUniforms::ShadowSources, in double precision. */
class OpaqueShadows
{
public:
  /** Surfaces whose data is the same as before keep their hierarchies, wherever they have moved. */
  void update(const std::vector<OpaqueSurface>& surfaces, vtkVolume* volume,
    const VolumeFrame& frame, const LightUniforms& lights);

  /** Whether a surface lies between a point of the normalised frame and a light, and not within
   * `margin` of the point. Thread-safe. */
  bool isShadowed(const Vector3& point, std::size_t source, double margin = 0) const;

  /** Gets the point of an index, in the normalised frame. False if there is none: no shadow. */
  using PointOf = std::function<bool(std::size_t, Vector3&)>;
  /** For each of so many points, in bit k whether it lies in the shadow of light k. In parallel. */
  std::vector<std::uint8_t> ofPoints(std::size_t count, const PointOf& pointOf) const;

  /** How many hierarchies were made in all. */
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
  std::uint8_t ofPoint(const Vector3& point) const;

  std::vector<Caster> Casters;
  std::vector<std::array<double, 4>> Sources;
  double Reach = 0;
  int Hierarchies = 0;
};

} // namespace tetmarch

#endif
