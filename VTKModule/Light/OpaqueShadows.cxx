// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/OpaqueShadows.h"

#include "Geometry/VolumeFrame.h"
#include "Parallel/ParallelFor.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetmarch
{
namespace
{

using Matrix = std::array<double, 16>;

constexpr std::size_t TexelsOfCaster = 4; // its matrix, and the place of its tree

Matrix times(const Matrix& a, const Matrix& b)
{
  Matrix product{};
  vtkMatrix4x4::Multiply4x4(a.data(), b.data(), product.data());
  return product;
}

Matrix normalizedToWorld(vtkVolume* volume, const VolumeFrame& frame)
{
  Matrix world{};
  vtkMatrix4x4::DeepCopy(world.data(), volume->GetMatrix());
  return times(world, frame.matrixToData());
}

// Transform a vector (w = 0) or a point (w = 1).
Vector3 transformed(const Matrix& m, const Vector3& v, double w)
{
  Vector3 result{};
  for (int r = 0; r < 3; ++r)
  {
    result[r] = m[4 * r] * v[0] + m[4 * r + 1] * v[1] + m[4 * r + 2] * v[2] + m[4 * r + 3] * w;
  }
  return result;
}

bool areOne(const OpaqueSurface& a, const OpaqueSurface& b)
{
  return a.Mapper == b.Mapper && a.ToWorld == b.ToWorld;
}

// A matrix without inverse leaves no volume, which casts no shadows.
bool isInvertible(const Matrix& matrix)
{
  const double determinant = vtkMatrix4x4::Determinant(matrix.data());
  return std::isfinite(determinant) && determinant != 0;
}

} // namespace

void OpaqueShadows::update(const std::vector<OpaqueSurface>& surfaces, vtkVolume* volume,
  const VolumeFrame& frame, const LightUniforms& lights)
{
  const Matrix toWorld = normalizedToWorld(volume, frame);
  std::vector<Caster> casters;
  for (auto surface = surfaces.begin(); surface != surfaces.end();)
  {
    // The blocks of one mapper have one hierarchy: a ray searches one after the other.
    const OpaqueSurface& first = *surface;
    Caster caster;
    std::vector<vtkPolyData*> pieces;
    for (; surface != surfaces.end() && areOne(*surface, first); ++surface)
    {
      pieces.push_back(surface->Data);
      add(caster.Data, surface->Data);
    }
    if (isInvertible(first.ToWorld))
    {
      caster.Triangles = this->hierarchyOf(pieces, caster.Data, casters);
      Matrix fromWorld{};
      vtkMatrix4x4::Invert(first.ToWorld.data(), fromWorld.data());
      caster.FromMesh = times(fromWorld, toWorld);
      if (!caster.Triangles->empty())
      {
        casters.push_back(caster);
      }
    }
  }
  this->Casters.swap(casters);
  this->Sources = lights.ShadowSources;
  this->Reach = lights.OpaqueReach;
}

// Several actors may show the same data.
std::shared_ptr<const TriangleHierarchy> OpaqueShadows::hierarchyOf(
  const std::vector<vtkPolyData*>& pieces, const Fingerprint& which,
  const std::vector<Caster>& made)
{
  for (const std::vector<Caster>* casters : { &made, &std::as_const(this->Casters) })
  {
    for (const Caster& caster : *casters)
    {
      if (caster.Data == which)
      {
        return caster.Triangles;
      }
    }
  }
  ++this->Hierarchies;
  return std::make_shared<const TriangleHierarchy>(trianglesOf(pieces));
}

std::vector<std::array<float, 4>> OpaqueShadows::texels() const
{
  constexpr std::size_t share = 4096; // of the number of a texel, which a float may not hold
  std::vector<std::array<float, 4>> texels(TexelsOfCaster * this->Casters.size());
  for (std::size_t c = 0; c < this->Casters.size(); ++c)
  {
    const Caster& caster = this->Casters[c];
    const TriangleHierarchy::Packed tree = caster.Triangles->packed();
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        const double moved = k == 3 ? caster.Triangles->center()[row] : 0;
        texels[TexelsOfCaster * c + row][k] =
          static_cast<float>((caster.FromMesh[4 * row + k] - moved) / caster.Triangles->radius());
      }
    }
    texels[TexelsOfCaster * c + 3] = { { static_cast<float>(tree.Leaves),
      static_cast<float>(tree.TrianglesOfLeaf), static_cast<float>(texels.size() / share),
      static_cast<float>(texels.size() % share) } };
    texels.insert(texels.end(), tree.Texels.begin(), tree.Texels.end());
  }
  return texels;
}

Fingerprint OpaqueShadows::version() const
{
  Fingerprint version;
  for (const Caster& caster : this->Casters)
  {
    add(version, caster.Data);
    addAll(version, caster.FromMesh);
  }
  return version;
}

bool OpaqueShadows::isShadowed(const Vector3& point, std::size_t source, double margin) const
{
  if (this->Casters.empty())
  {
    return false;
  }
  const auto& light = this->Sources[source];
  Vector3 way{ { light[0], light[1], light[2] } };
  add(-light[3], point, way);
  const double far = std::sqrt(dot(way, way));
  const Vector3 direction = scaled(1 / far, way);
  Vector3 origin = point;
  add(margin, direction, origin);
  const double end = (light[3] > 0 ? std::min(far, this->Reach) : this->Reach) - margin;
  return std::any_of(this->Casters.begin(), this->Casters.end(),
    [&](const Caster& caster)
    {
      return caster.Triangles->isHit(
        transformed(caster.FromMesh, origin, 1), transformed(caster.FromMesh, direction, 0), end);
    });
}

std::uint8_t OpaqueShadows::ofPoint(const Vector3& point) const
{
  std::uint8_t shadows = 0;
  for (std::size_t k = 0; k < this->Sources.size(); ++k)
  {
    shadows |= this->isShadowed(point, k) ? 1u << k : 0u;
  }
  return shadows;
}

std::vector<std::uint8_t> OpaqueShadows::ofPoints(std::size_t count, const PointOf& pointOf) const
{
  std::vector<std::uint8_t> shadows(count);
  parallelFor(0, static_cast<vtkIdType>(count),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        Vector3 point;
        shadows[i] = pointOf(static_cast<std::size_t>(i), point) ? this->ofPoint(point) : 0;
      }
    });
  return shadows;
}

} // namespace tetmarch
