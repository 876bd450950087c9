// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The variant that a frame's scene needs, for both kinds of volume.
#include "StagedFrame.h"

#include "ComponentFields.h"
#include "Grids.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr double ManyPixels = 1e6;

template <typename VolumeOf>
VariantKey keyOf(const StagedFrame<VolumeOf>& frame, double pixels = ManyPixels)
{
  VariantKey key;
  frame.Stages.setBits(key, pixels);
  return key.filtered();
}

// "+FEATURE" for each that only the second key has, "-FEATURE" for each that only the first has, in
// the order of Variants/features.txt.
std::string difference(const VariantKey& from, const VariantKey& to)
{
  std::string text;
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    if (feature.isOn(from) != feature.isOn(to))
    {
      text += (text.empty() ? "" : " ") + std::string(feature.isOn(to) ? "+" : "-") + feature.Name;
    }
  }
  return text;
}

VariantKey nothing()
{
  VariantKey key;
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    feature.set(key, false);
  }
  return key;
}

void drawComponents(StagedScene& scene, int count, bool independent)
{
  setComponents(scene.Data, componentFields(count), VTK_DOUBLE);
  setComponentFunctions(scene.property(), count);
  scene.property()->SetIndependentComponents(independent);
  scene.Input.Drawn.Vector.Mode = VectorMode::AllComponents;
  scene.draw(scene.Data);
}

/// What a scene changes of the key of a plain one, which is all of it: no other bit may change.
struct KeyCase
{
  const char* Name;
  std::function<void(StagedScene&)> Change;
  const char* OfMesh;
  const char* OfLattice;
  double Pixels = ManyPixels;
};

const KeyCase KeyCases[] = {
  // Data.
  { "scalars of cells", [](StagedScene& s) { s.draw(s.Data, true); }, "-POINT_SCALARS -ADAPTIVE",
    "" },
  { "values of points, constant around each",
    [](StagedScene& s) { s.Input.Drawn.Volume.Between = Interpolation::Nearest; }, "",
    "-POINT_SCALARS -ADAPTIVE" },
  { "a hidden cell", [](StagedScene& s) { s.hideCell(7); }, "+HIDDEN_CELLS", "+HIDDEN_CELLS" },
  { "no hidden cell", [](StagedScene& s) { s.hideCell(-1); }, "", "" },
  { "not a number, drawn",
    [](StagedScene& s)
    {
      s.spoilPoint();
      s.Input.DrawNan = true;
    },
    "+NAN_SHOWN", "+NAN_SHOWN" },
  { "not a number, left out", [](StagedScene& s) { s.spoilPoint(); }, "", "" },
  { "all are numbers, others would be drawn", [](StagedScene& s) { s.Input.DrawNan = true; }, "",
    "" },
  { "two components", [](StagedScene& s) { drawComponents(s, 2, true); }, "+INDEPENDENT",
    "+INDEPENDENT" },
  { "colour and opacity", [](StagedScene& s) { drawComponents(s, 2, false); }, "+COLOR_AND_OPACITY",
    "+COLOR_AND_OPACITY" },
  { "colours as they are", [](StagedScene& s) { drawComponents(s, 4, false); }, "+DIRECT_COLOR",
    "+DIRECT_COLOR" },
  // Transfer functions.
  { "one colour",
    [](StagedScene& s) { s.property()->GetRGBTransferFunction()->AddRGBPoint(0, 1, 0.3, 0.1); },
    "-ADAPTIVE +CONSTANT_COLOR", "+CONSTANT_COLOR" },
  { "a quarter is transparent",
    [](StagedScene& s) {
      s.show({ { 0.3, 0.0 }, { 1.0, 0.6 } });
    },
    "", "+LEAPS" },
  { "half is transparent",
    [](StagedScene& s) {
      s.show({ { 0.55, 0.0 }, { 1.0, 0.6 } });
    },
    "+VISIBLE_PART +REENTERED", "+TRANSPARENT_RANGES +LEAPS" },
  { "half of the points, here and there, are transparent",
    [](StagedScene& s)
    {
      const Field noise = scatteredField(1);
      vtkImageData::SafeDownCast(s.Data) ? s.draw(imageOf(noise))
                                         : s.draw(jitteredLattice(4, 0.0, 1, noise));
      s.show({ { 0.55, 0.0 }, { 1.0, 0.6 } });
    },
    "+TRANSPARENT_RANGES", "" },
  { "half is transparent in a sum",
    [](StagedScene& s)
    {
      s.show({ { 0.55, 0.0 }, { 1.0, 0.6 } });
      s.blend(BlendMode::Additive);
    },
    "-ADAPTIVE +SUM", "-ADAPTIVE +SUM" },
  // Blend modes.
  { "maximum", [](StagedScene& s) { s.blend(BlendMode::Maximum); }, "-ADAPTIVE +EXTREME",
    "-ADAPTIVE +EXTREME" },
  { "minimum", [](StagedScene& s) { s.blend(BlendMode::Minimum); }, "-ADAPTIVE +EXTREME",
    "-ADAPTIVE +EXTREME" },
  { "average", [](StagedScene& s) { s.blend(BlendMode::Average); }, "-ADAPTIVE +SUM",
    "-ADAPTIVE +SUM" },
  { "a surface",
    [](StagedScene& s)
    {
      s.property()->GetIsoSurfaceValues()->SetValue(0, 0.4);
      s.blend(BlendMode::IsoSurface);
    },
    "-ADAPTIVE +ISOSURFACES +VISIBLE_PART", "-ADAPTIVE +ISOSURFACES +LEAPS" },
  // Views and cuts.
  { "the eye in the volume",
    [](StagedScene& s) { s.Renderer->GetActiveCamera()->SetPosition(0.5, 0.45, 0.6); },
    "+VISIBLE_PART +REENTERED", "" },
  { "the eye in the volume, for a sum",
    [](StagedScene& s)
    {
      s.Renderer->GetActiveCamera()->SetPosition(0.5, 0.45, 0.6);
      s.blend(BlendMode::Additive);
    },
    "-ADAPTIVE +SUM +VISIBLE_PART +REENTERED", "-ADAPTIVE +SUM" },
  { "a clipping plane",
    [](StagedScene& s)
    {
      static const vtkNew<vtkPlaneCollection> planes;
      static const vtkNew<vtkPlane> plane;
      planes->RemoveAllItems();
      planes->AddItem(plane);
      s.Input.Drawn.Cuts.Planes = planes;
    },
    "+CLIPPED", "+CLIPPED" },
  { "a cropped box", [](StagedScene& s) { s.crop(true); }, "+CLIPPED", "+CLIPPED" },
  { "all but a cropped box", [](StagedScene& s) { s.crop(false); }, "+CLIPPED +CROPPED",
    "+CLIPPED +CROPPED" },
  // Light.
  { "shading without a light", [](StagedScene& s) { s.property()->ShadeOn(); }, "", "" },
  { "a headlight", [](StagedScene& s) { s.shineFromEye(); }, "+SHADING +HEADLIGHT_ONLY",
    "+SHADING +HEADLIGHT_ONLY" },
  { "shadows stored at vertices", [](StagedScene& s) { s.castShadow(); },
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS", "+SHADING +SINGLE_LIGHT +CAST_SHADOWS" },
  { "shadows where they are cheaper, of many pixels",
    [](StagedScene& s) { s.castShadow(ShadowMethod::Automatic); },
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS", "+SHADING +SINGLE_LIGHT +CAST_SHADOWS" },
  { "shadows where they are cheaper, of a pixel",
    [](StagedScene& s) { s.castShadow(ShadowMethod::Automatic); },
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS +SAMPLED_SHADOWS",
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS +SAMPLED_SHADOWS", 1 },
  { "sampled shadows in a volume that rays may enter again, with uneven planes",
    [](StagedScene& s)
    {
      const Field field = linearField();
      vtkImageData::SafeDownCast(s.Data) ? s.draw(rectilinearOf(field))
                                         : s.draw(latticeWithHole(4, 0.0, 1, field));
      s.castShadow(ShadowMethod::AlongRays);
    },
    "+BVH +SHADING +SINGLE_LIGHT +CAST_SHADOWS +SAMPLED_SHADOWS +REENTERED",
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS +SAMPLED_SHADOWS +RECTILINEAR" },
  { "a plate between the light and the volume",
    [](StagedScene& s)
    {
      s.castShadow();
      s.addPlate();
    },
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS +OPAQUE_SHADOWS",
    "+SHADING +SINGLE_LIGHT +CAST_SHADOWS +OPAQUE_SHADOWS" },
  { "opacity by the gradient", [](StagedScene& s) { s.addGradientOpacity(); }, "+GRADIENT_OPACITY",
    "+GRADIENT_OPACITY" },
  { "light on cells of one gradient",
    [](StagedScene& s)
    {
      s.shineFromEye();
      s.Input.Effects.CellGradients = true;
    },
    "+CELL_GRADIENTS +SHADING +HEADLIGHT_ONLY", "+CELL_GRADIENTS +SHADING +HEADLIGHT_ONLY" },
};

template <typename VolumeOf>
class FrameKeys : public ::testing::Test
{
};
using Kinds = ::testing::Types<TetVolume, StructuredVolume>;
TYPED_TEST_SUITE(FrameKeys, Kinds, );

TYPED_TEST(FrameKeys, HaveTheBitsOfTheScene)
{
  StagedFrame<TypeParam> plain;
  ASSERT_TRUE(plain.update().isDone());
  const bool isLattice = plain.Marched.isStructured();
  EXPECT_EQ(difference(nothing(), keyOf(plain)),
    isLattice ? "+POINT_SCALARS +ADAPTIVE +STRUCTURED"
              : "+POINT_SCALARS +ENTRY_LISTS +HAS_FMA +ADAPTIVE");
  for (const KeyCase& c : KeyCases)
  {
    StagedFrame<TypeParam> frame;
    c.Change(frame);
    EXPECT_EQ(frame.update().Error, "") << c.Name;
    EXPECT_EQ(difference(keyOf(plain), keyOf(frame, c.Pixels)), isLattice ? c.OfLattice : c.OfMesh)
      << c.Name;
  }
}

// Another variant takes long to compile, so that a function that is dragged keeps it as long as it
// isn't clearly slower; other data chooses anew.
TYPED_TEST(FrameKeys, ChangeOnlyIfAnotherIsClearlyFaster)
{
  StagedFrame<TypeParam> frame;
  ASSERT_TRUE(frame.update().isDone());
  const VariantKey plain = keyOf(frame);
  const auto expectKey = [&](double transparentTo, const char* ofMesh, const char* ofLattice)
  {
    frame.show({ { transparentTo, 0.0 }, { 1.0, 0.6 } });
    EXPECT_TRUE(frame.update().isDone());
    EXPECT_EQ(difference(plain, keyOf(frame)), frame.Marched.isStructured() ? ofLattice : ofMesh);
  };
  expectKey(0.3, "", "+LEAPS");
  expectKey(0.55, "+VISIBLE_PART +REENTERED", "+TRANSPARENT_RANGES +LEAPS");
  expectKey(0.3, "+VISIBLE_PART +REENTERED", "+TRANSPARENT_RANGES +LEAPS");
  frame.Input.Drawn.Scalars.Array->Modified();
  expectKey(0.3, "", "+LEAPS");
  expectKey(0.55, "+VISIBLE_PART +REENTERED", "+TRANSPARENT_RANGES +LEAPS");
  expectKey(0.1, "", "");
}
} // namespace
