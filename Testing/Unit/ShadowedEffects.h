// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A lattice with vertices in the shadow of opaque geometry, and which of them ought to be
 */
#ifndef tetmarch_testing_ShadowedEffects_h
#define tetmarch_testing_ShadowedEffects_h

#include "Mesh/VertexStarts.h"
#include "OpaqueProps.h"
#include "StagedEffects.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tetmarch::testing
{
/// A shaded lattice with shadows at vertices; nothing casts a shadow yet.
class ShadowedEffects : public StagedEffects
{
protected:
  ShadowedEffects()
  {
    this->Data = jitteredLattice(9, 0.15, 1, sineField());
    this->readData();
    this->property()->ShadeOn();
    this->Options.Shadows = ShadowMethod::AtVertices;
    this->Options.OpaqueShadows = true;
  }

  // The point in the world where the ray of a vertex towards the light starts.
  Vector3 pointOf(std::size_t vertex)
  {
    const auto& start = this->Stage.data().VertexStarts[vertex];
    Vector3 others{};
    for (const Id other :
      { start[0], start[1], fourthVertex(this->Mesh, static_cast<Id>(vertex), start) })
    {
      add(1.0 / 3.0, position(this->Mesh.Vertices[other]), others);
    }
    const Vector3 place = position(this->Mesh.Vertices[vertex]);
    double p[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int k = 0; k < 3; ++k)
    {
      p[k] = this->Mesh.Frame.Center[k] +
             this->Mesh.Frame.Radius * (place[k] + (others[k] - place[k]) / 64.0);
    }
    this->Volume->GetMatrix()->MultiplyPoint(p, p);
    return { { p[0], p[1], p[2] } };
  }

  std::vector<std::uint8_t> shadows()
  {
    EXPECT_EQ(this->update(), "");
    return this->Stage.data().ShadowedVertices;
  }

  // depth(point) is how deep a vertex lies in the shadow of a light, below 0 outside; where it is
  // less than `unsure`, anything may be.
  void expectShadow(int light, const std::function<double(const Vector3&)>& depth, double unsure)
  {
    const std::vector<std::uint8_t> found = this->shadows();
    ASSERT_EQ(found.size(), this->Mesh.Vertices.size());
    int shadowed = 0;
    int checked = 0;
    for (std::size_t v = 0; v < found.size(); ++v)
    {
      const double deep = depth(this->pointOf(v));
      if (std::abs(deep) > unsure)
      {
        EXPECT_EQ(found[v] >> light & 1, deep > 0.0 ? 1 : 0) << v << ": " << deep;
        shadowed += deep > 0.0 ? 1 : 0;
        ++checked;
      }
    }
    EXPECT_GT(20 * checked, 19 * static_cast<int>(found.size()));
    EXPECT_GT(10 * shadowed, checked) << "hardly any shadow";
    EXPECT_LT(10 * shadowed, 9 * checked) << "hardly any light";
  }

  void expectNoShadow()
  {
    const std::vector<std::uint8_t> found = this->shadows();
    ASSERT_EQ(found.size(), this->Mesh.Vertices.size());
    for (std::uint8_t bits : found)
    {
      ASSERT_EQ(bits, 0);
    }
  }

  // There are no shadows, and no data of them.
  void expectNone()
  {
    EXPECT_TRUE(this->shadows().empty());
    EXPECT_EQ(this->Stage.data().ShadowedVertices.capacity(), 0u);
    EXPECT_EQ(this->Stage.opaqueShadowsVersion(), Fingerprint{ 0 });
    EXPECT_FALSE(this->key().OpaqueShadows);
  }

  vtkSmartPointer<vtkLight> addLightSource(double x, double y, double z)
  {
    auto source = this->addLight(x, y, z);
    source->PositionalOn();
    source->SetConeAngle(180.0);
    return source;
  }
};

/// How far inside of the plate [0.2, 0.7] x [0.3, 0.9] at that height a ray from the point meets
/// it; negative outside.
inline double depthUnderPlate(const Vector3& point, const Vector3& direction, double height)
{
  const double t = (height - point[2]) / direction[2];
  const double x = point[0] + t * direction[0];
  const double y = point[1] + t * direction[1];
  return std::min(std::min(x - 0.2, 0.7 - x), std::min(y - 0.3, 0.9 - y));
}

inline vtkSmartPointer<vtkActor> plateAt(double height)
{
  return actorOf(
    plate({ { 0.2, 0.3, height } }, { { 0.7, 0.3, height } }, { { 0.2, 0.9, height } }));
}

/// The rounding of depths.
constexpr double Rounding = 1e-6;
} // namespace tetmarch::testing

#endif
