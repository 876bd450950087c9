// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A volume between translucent surfaces, and what depth peeling has to show of them
 */
#ifndef tetmarch_testing_PeeledScene_h
#define tetmarch_testing_PeeledScene_h

#include "Scene.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>
#include <iostream>
#include <memory>
#include <vector>

namespace tetmarch::testing
{
/// A plane through the cube, seen from above.
struct Layer
{
  double Height;
  std::array<double, 3> Colour;
  double Opacity;
};

class PeeledScene : public ::testing::Test
{
protected:
  PeeledScene() { this->use(jitteredLattice(8, 0.15, 1, sineField())); }

  void use(vtkUnstructuredGrid* grid)
  {
    this->Shown = std::make_unique<Scene>(grid);
    prepare(*this->Shown);
    this->Shown->property()->SetScalarOpacityUnitDistance(0.6);
  }

  static void prepare(Scene& scene)
  {
    scene.Window->AlphaBitPlanesOn();
    scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  }

  static void peel(Scene& scene, bool on)
  {
    scene.Renderer->SetUseDepthPeeling(on);
    scene.Renderer->SetUseDepthPeelingForVolumes(on);
    scene.Renderer->SetMaximumNumberOfPeels(20);
    scene.Renderer->SetOcclusionRatio(0.0);
  }
  void peel(bool on) { peel(*this->Shown, on); }

  static vtkSmartPointer<vtkActor> planeOf(const Layer& layer, double opacity)
  {
    auto plane = makePlane(layer.Height, 0.2, layer.Colour);
    plane->GetProperty()->SetOpacity(opacity);
    return plane;
  }

  /// The volume in front of an opaque surface in the place of a layer; covered is where that is.
  Image volumeBefore(const Layer& layer, Mask& covered);
  /// Without peeling: the sum over layers of what the volume adds in front of each.
  Image expected(const std::vector<Layer>& layers);
  void expectPeeled(const std::vector<Layer>& layers);

  std::unique_ptr<Scene> Shown;
};

inline Image PeeledScene::volumeBefore(const Layer& layer, Mask& covered)
{
  Scene& scene = *this->Shown;
  const auto plane = planeOf(layer, 1.0);
  scene.Renderer->AddActor(plane);
  const Image before = scene.render();
  scene.Volume->VisibilityOff();
  scene.Window->Render();
  const float background[] = { 0.2f, 0.4f, 0.6f };
  covered = differsFrom(scene.frame(), background, 0.05f);
  scene.Volume->VisibilityOn();
  scene.Renderer->RemoveActor(plane);
  return before;
}

// In front of each layer the volume adds what it has before this one and hadn't before the last.
inline Image PeeledScene::expected(const std::vector<Layer>& layers)
{
  this->peel(false);
  Scene& scene = *this->Shown;
  std::vector<Image> before;
  std::vector<Mask> covered(layers.size());
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    before.push_back(this->volumeBefore(layers[k], covered[k]));
  }
  const Image all = scene.render();
  double background[3];
  scene.Renderer->GetBackground(background);
  Image result(all.Width, all.Height);
  for (std::size_t p = 0; p < covered[0].size(); ++p)
  {
    const float* last = nullptr;
    float seen = 1.0f; // through the surfaces so far
    const auto addVolume = [&](const Image& upTo)
    {
      const float* here = &upTo.Rgba[4 * p];
      for (int c = 0; c < 3; ++c)
      {
        result.Rgba[4 * p + c] += seen * (here[c] - (last ? last[c] : 0.0f));
      }
      last = here;
    };
    for (std::size_t k = 0; k < layers.size(); ++k)
    {
      if (covered[k][p])
      {
        addVolume(before[k]);
        const auto opacity = static_cast<float>(layers[k].Opacity);
        for (int c = 0; c < 3; ++c)
        {
          result.Rgba[4 * p + c] +=
            seen * (1.0f - last[3]) * opacity * static_cast<float>(layers[k].Colour[c]);
        }
        seen *= 1.0f - opacity;
      }
    }
    if (seen > 0.0f)
    {
      addVolume(all);
    }
    for (int c = 0; c < 3; ++c)
    {
      result.Rgba[4 * p + c] += seen * (1.0f - last[3]) * static_cast<float>(background[c]);
    }
  }
  return result;
}

/// Each peel is rounded to bytes, before and after what is behind it has been blended in.
inline void expectSame(const Image& found, const Image& expected, std::size_t peels)
{
  const double bound = (1.5 + static_cast<double>(peels)) / 255.0;
  const Difference difference = compare(found, expected, {}, bound, Channels::Rgb);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_LE(difference.Max, bound) << difference.text();
}

inline void PeeledScene::expectPeeled(const std::vector<Layer>& layers)
{
  const Image picture = this->expected(layers);
  std::vector<vtkSmartPointer<vtkActor>> planes;
  for (const Layer& layer : layers)
  {
    planes.push_back(planeOf(layer, layer.Opacity));
    this->Shown->Renderer->AddActor(planes.back());
  }
  this->peel(true);
  this->Shown->Window->Render();
  expectSame(this->Shown->frame(), picture, layers.size());
  EXPECT_EQ(this->Shown->Mapper->GetNumberOfRays(), 0);
  for (const auto& plane : planes)
  {
    this->Shown->Renderer->RemoveActor(plane);
  }
}

/// The camera of the scene looks down on them.
inline const Layer Top{ 0.8, { { 0.9, 0.1, 0.1 } }, 0.4 };
inline const Layer Middle{ 0.5, { { 0.1, 0.9, 0.3 } }, 0.5 };
inline const Layer Low{ 0.25, { { 0.2, 0.2, 1.0 } }, 0.3 };
inline const Layer Floor{ -0.1, { { 1.0, 1.0, 0.0 } }, 1.0 };
} // namespace tetmarch::testing

#endif
