// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Effects of a volume that is no mesh: they ask the source, and only for what the scene needs.
#include "StagedEffects.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Two points, of which the second lies in no cell.
class TwoPoints : public EffectSource
{
public:
  const VolumeFrame& frame() const override { return this->Frame; }
  const ScalarRange& range() const override { return this->Range; }
  Fingerprint geometryVersion() const override { return { this->Geometry }; }
  Fingerprint scalarsVersion() const override { return { this->Geometry, this->Scalars }; }
  bool hasCellGradients() const override { return false; }
  std::vector<std::array<float, 3>> gradients(bool ofCells, Group*) const override
  {
    EXPECT_FALSE(ofCells);
    ++this->AskedForGradients;
    return { { { 0.0f, 3.0f, 4.0f } }, { { 0.0f, 0.0f, 0.0f } } };
  }
  std::vector<VertexStart> vertexStarts() const override
  {
    ++this->AskedForStarts;
    return { { { 1, 0, 0, 0 } }, {} };
  }
  bool startPoint(std::size_t vertex, const VertexStart&, Vector3& point) const override
  {
    point = { { 0.5, 0.0, 0.0 } };
    return vertex == 0;
  }

  VolumeFrame Frame{ { { 1.0, 2.0, 3.0 } }, 2.0, { { 0.5, 0.5, 0.5 } } };
  ScalarRange Range{ 10.0, 30.0 };
  std::uintptr_t Geometry = 1;
  std::uintptr_t Scalars = 1;
  mutable int AskedForGradients = 0;
  mutable int AskedForStarts = 0;
};

class EffectsOfAnyVolume : public StagedEffects
{
protected:
  void update()
  {
    EXPECT_EQ(
      this->Stage.update(this->Renderer, this->Volume, this->Options, { &this->Points }), "");
  }

  TwoPoints Points;
};

TEST_F(EffectsOfAnyVolume, AreNoneInAPlainScene)
{
  this->update();
  EXPECT_EQ(this->Points.AskedForGradients, 0);
  EXPECT_EQ(this->Points.AskedForStarts, 0);
}

TEST_F(EffectsOfAnyVolume, HaveItsGradients)
{
  this->property()->ShadeOn();
  this->addHeadlight();
  this->addGradientOpacity();
  this->Options.CellGradients = true; // it has none
  this->update();
  this->update();
  EXPECT_EQ(this->Points.AskedForGradients, 1);
  EXPECT_EQ(this->Points.AskedForStarts, 0);
  const EffectData& data = this->Stage.data();
  EXPECT_EQ(data.Gradients, this->Points.gradients(false, nullptr));
  EXPECT_FALSE(data.CellGradients);
  // 20 of the data's units over a radius of 2.
  EXPECT_DOUBLE_EQ(data.GradientOpacityScale * data.GradientOpacity.Unit, 10.0);
}

TEST_F(EffectsOfAnyVolume, FollowItsVersions)
{
  this->property()->ShadeOn();
  this->addSun();
  this->Options.Shadows = ShadowMethod::AtVertices;
  this->update();
  this->Points.Scalars = 2;
  this->update();
  EXPECT_EQ(this->Points.AskedForGradients, 2);
  EXPECT_EQ(this->Points.AskedForStarts, 1);
  this->Points.Geometry = 2;
  this->update();
  EXPECT_EQ(this->Points.AskedForGradients, 3);
  EXPECT_EQ(this->Points.AskedForStarts, 2);
}
} // namespace
