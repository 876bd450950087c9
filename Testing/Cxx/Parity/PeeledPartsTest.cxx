// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of a volume before and behind a translucent surface: each of them is what a clipping
// plane leaves, whatever is drawn of the volume.
#include "BlendScene.h"
#include "ComponentScene.h"
#include "CutScene.h"
#include "GapScene.h"
#include "PeeledScene.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using Peeling = PeeledScene;

// Independent components are drawn without light.
void drawMix(BlendScene& scene, const Mix& mix)
{
  withComponents(scene.Data, wavyFields(mix.Components), VTK_DOUBLE);
  drawComponents(scene, mix);
  scene.property()->SetShade(!mix.Independent);
}

// Whatever is drawn of the volume, before and behind a surface it is what a clipping plane in the
// surface's place leaves of it.
TEST_F(Peeling, PartsAreThoseThatAPlaneCutsOff)
{
  struct Kind
  {
    const char* Name;
    void (*Set)(BlendScene& scene);
  };
  const Kind kinds[] = {
    { "maximum", [](BlendScene& s) { s.Mapper->SetBlendModeToMaximumIntensity(); } },
    { "minimum", [](BlendScene& s) { s.Mapper->SetBlendModeToMinimumIntensity(); } },
    { "average", [](BlendScene& s) { s.Mapper->SetBlendModeToAverageIntensity(); } },
    { "additive", [](BlendScene& s) { s.Mapper->SetBlendModeToAdditive(); } },
    { "surfaces", [](BlendScene& s) { s.Mapper->SetBlendModeToIsoSurface(); } },
    { "gradient opacity, shadows, occlusion and scattering",
      [](BlendScene& s)
      {
        s.addGradientOpacity();
        s.Mapper->SetShadowMethodToAtVertices();
        s.Mapper->AmbientOcclusionOn();
        s.Mapper->SetVolumetricScatteringBlending(1.3f);
      } },
    { "shadows along rays", [](BlendScene& s) { s.Mapper->SetShadowMethodToAlongRays(); } },
    { "shadows of a headlight",
      [](BlendScene& s)
      {
        s.Sun->SetLightTypeToHeadlight();
        s.Mapper->SetShadowMethodToAutomatic();
      } },
    { "what is not finite, and hidden cells",
      [](BlendScene& s)
      {
        breakSome(s.Data->GetPointData()->GetScalars());
        hide(s.Data, isCrumb);
        s.Mapper->DrawNanCellsOn();
      } },
    { "independent components", [](BlendScene& s) { drawMix(s, Mixes[0]); } },
    { "colour and opacity", [](BlendScene& s) { drawMix(s, Mixes[3]); } },
    { "direct colour", [](BlendScene& s) { drawMix(s, Mixes[4]); } },
  };
  for (const Kind& kind : kinds)
  {
    SCOPED_TRACE(kind.Name);
    BlendScene scene(jitteredLattice(6, 0.15, 1, sineField()), 96, 96);
    prepare(scene);
    kind.Set(scene);
    const auto cut = addClippingPlane(scene, { 0.0, 0.0, Middle.Height }, { 0.0, 0.0, 1.0 });
    const Image before = scene.render();
    cut->SetNormal(0.0, 0.0, -1.0);
    const Image behind = scene.render();
    scene.Mapper->RemoveAllClippingPlanes();

    const auto plane = planeOf(Middle, Middle.Opacity);
    scene.Renderer->AddActor(plane);
    peel(scene, true);
    scene.Volume->VisibilityOff();
    scene.Window->Render();
    const float background[] = { 0.2f, 0.4f, 0.6f };
    const Image surface = scene.frame(); // blended over the background
    const Mask covered = differsFrom(surface, background, 0.05f);
    scene.Volume->VisibilityOn();
    scene.Window->Render();

    Image expected(before.Width, before.Height);
    const auto opacity = static_cast<float>(Middle.Opacity);
    for (std::size_t p = 0; p < covered.size(); ++p)
    {
      const float* front = &before.Rgba[4 * p];
      const float* back = &behind.Rgba[4 * p];
      for (int c = 0; c < 3; ++c)
      {
        const float rest = back[c] + (1.0f - back[3]) * background[c];
        const float behindFront =
          opacity * static_cast<float>(Middle.Colour[c]) + (1.0f - opacity) * rest;
        expected.Rgba[4 * p + c] = front[c] + (1.0f - front[3]) * behindFront;
      }
    }
    // Beside the surface a ray is one part.
    const double bound = 2.5 / 255.0;
    const Difference difference = compare(scene.frame(), expected, covered, bound, Channels::Rgb);
    std::cout << "[ MEASURED ] " << kind.Name << ": " << difference.text() << '\n';
    EXPECT_GT(difference.Pixels, 1000u);
    EXPECT_LE(100 * difference.Over, difference.Pixels) << difference.text();
    EXPECT_LE(difference.Rms, 0.8 / 255.0) << difference.text();
  }
}
} // namespace
