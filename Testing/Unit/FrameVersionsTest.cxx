// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A frame uploads and computes only what has changed: each version changes with what it is the
// version of, and with nothing else, for both kinds of volume.
#include "StagedFrame.h"

#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

Fingerprint visibleVersion(const TetVolume& volume) { return volume.visibleVersion(); }
Fingerprint visibleVersion(const StructuredVolume& volume) { return volume.emptySpaceVersion(); }

template <typename VolumeOf>
std::map<std::string, Fingerprint> versionsOf(const StagedFrame<VolumeOf>& frame)
{
  VariantKey key;
  frame.Stages.setBits(key, 1e6);
  return { { "geometry", frame.Marched.geometryVersion() },
    { "scalars", frame.Marched.scalarsVersion() }, { "hidden", frame.Marched.hiddenVersion() },
    { "volume", frame.Marched.version() }, { "visible", visibleVersion(frame.Marched) },
    { "content", frame.Stages.contentVersion() }, { "light", frame.Stages.lightVersion(key) } };
}

/// The versions that a change of a frame changes, in alphabetical order: no other one may, since
/// what it is the version of would be uploaded, or the light at vertices drawn, once more.
struct VersionCase
{
  const char* Name;
  std::function<void(StagedScene&)> Change;
  const char* Changed;
  const char* OfTets = nullptr; ///< if it differs for them
};

const VersionCase VersionCases[] = {
  { "nothing", [](StagedScene&) {}, "" },
  { "geometry",
    [](StagedScene& s)
    {
      if (auto* image = vtkImageData::SafeDownCast(s.Data))
      {
        image->SetOrigin(1, 0, 0);
        return;
      }
      auto* points = vtkPointSet::SafeDownCast(s.Data)->GetPoints();
      points->SetPoint(0, -0.1, -0.1, -0.1);
      points->Modified();
    },
    "content geometry light scalars visible volume" },
  { "scalars", [](StagedScene& s) { s.Input.Drawn.Scalars.Array->Modified(); },
    "content light scalars visible volume" },
  { "hidden cells", [](StagedScene& s) { s.hideCell(7); }, "content hidden light volume",
    "content hidden light visible volume" },
  { "opacity",
    [](StagedScene& s) {
      s.show({ { 0.0, 0.2 }, { 1.0, 0.6 } });
    },
    "content light" },
  { "opacity that shows something else",
    [](StagedScene& s) {
      s.show({ { 0.3, 0.0 }, { 1.0, 0.6 } });
    },
    "content light visible" },
  { "colour",
    [](StagedScene& s) { s.property()->GetRGBTransferFunction()->AddRGBPoint(0.5, 1, 1, 1); },
    "content light" },
  { "unit distance", [](StagedScene& s) { s.property()->SetScalarOpacityUnitDistance(2); },
    "content light" },
  { "gradient opacity",
    [](StagedScene& s) { s.property()->GetGradientOpacity()->AddPoint(0.25, 0.2); }, "light" },
  { "blend mode", [](StagedScene& s) { s.blend(BlendMode::Maximum); }, "content light visible" },
  { "a scalar that is not a number is drawn", [](StagedScene& s) { s.Input.DrawNan = true; },
    "content light visible" },
  { "direction of a light, with the same shadow of the plate",
    [](StagedScene& s) { s.Light->SetPosition(3, 4, 1.0001); }, "light" },
  { "colour of a light", [](StagedScene& s) { s.Light->SetColor(1, 0, 0); }, "" },
  { "reach of shadows, still beyond the plate",
    [](StagedScene& s) { s.Input.Effects.Reach = 0.999; }, "light" },
  { "radius of occlusion", [](StagedScene& s) { s.Input.Effects.OcclusionRadius = 0.3; }, "light" },
  { "rays of occlusion", [](StagedScene& s) { s.Input.Effects.OcclusionDirections = 24; },
    "light" },
  { "a plate that shades elsewhere", [](StagedScene& s) { s.Plate->SetPosition(-0.3, 0, -0.2); },
    "light" },
  { "a plate that shades nothing else", [](StagedScene& s) { s.Plate->SetPosition(0, 1e-9, 0); },
    "" },
  { "where shadows are sampled",
    [](StagedScene& s) { s.Input.Effects.Shadows = ShadowMethod::AlongRays; }, "light" },
  { "shine", [](StagedScene& s) { s.property()->SetSpecular(0.7); }, "" },
  { "camera", [](StagedScene& s) { s.Renderer->GetActiveCamera()->Azimuth(30); }, "" },
  { "cuts", [](StagedScene& s) { s.crop(true); }, "" },
  { "level of accuracy, with the same tables",
    [](StagedScene& s) { s.Input.Level.Adaptive = !s.Input.Level.Adaptive; }, "" },
};

template <typename VolumeOf>
class FrameVersions : public ::testing::Test
{
};
using Kinds = ::testing::Types<TetVolume, StructuredVolume>;
TYPED_TEST_SUITE(FrameVersions, Kinds, );

TYPED_TEST(FrameVersions, ChangeWithWhatTheyAreOf)
{
  for (const VersionCase& c : VersionCases)
  {
    StagedFrame<TypeParam> frame;
    frame.spoilPoint();
    frame.castShadow();
    frame.addPlate();
    frame.addGradientOpacity();
    frame.property()->SetAmbient(0.2);
    frame.Input.Effects.Occlusion = true;
    ASSERT_TRUE(frame.update().isDone());
    const auto before = versionsOf(frame);
    c.Change(frame);
    EXPECT_EQ(frame.update().Error, "") << c.Name;
    std::string changed;
    for (const auto& [name, version] : versionsOf(frame))
    {
      if (version != before.at(name))
      {
        changed += (changed.empty() ? "" : " ") + name;
      }
    }
    const bool isOfTets = std::is_same_v<TypeParam, TetVolume> && c.OfTets;
    EXPECT_EQ(changed, isOfTets ? c.OfTets : c.Changed) << c.Name;
  }
}
} // namespace
