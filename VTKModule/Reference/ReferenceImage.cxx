// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ReferenceImage.h"

#include "Reference/KernelTable.h"
#include "Variants/VariantKey.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace tetmarch
{
namespace
{

bool isLit(const ReferenceScene& scene)
{
  const bool surfaces = scene.Blend && scene.Blend->isIsoSurface();
  return scene.Effects &&
         (surfaces ? !scene.Effects->Lights.Sources.empty() : !scene.Effects->empty());
}

// The key of the picture, as far as kernels differ by it.
VariantKey keyOf(const ReferenceScene& scene, const AccuracyLevel& level)
{
  VariantKey key;
  key.Structured = scene.Cells != nullptr;
  key.PointScalars = scene.Cells ? !scene.Cells->Constant : scene.CellScalars == nullptr;
  key.CornerScalars = scene.CornerScalars != nullptr;
  key.Adaptive = level.Adaptive;
  key.PointSampled = level.Sampled;
  if (scene.Blend)
  {
    scene.Blend->setBits(key);
  }
  if (scene.Parts)
  {
    scene.Parts->setBits(key);
  }
  key.Shading = isLit(scene);
  key.CellGradients = scene.Effects && scene.Effects->CellGradients;
  return key.filtered();
}

} // namespace

template <typename Real>
ReferenceImage renderReference(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const std::uint64_t chosen = keyOf(scene, level).bits() & chosenFeatures();
  const auto& kernels = pictureKernels();
  const auto kernel = std::find_if(kernels.begin(), kernels.end(),
    [chosen](const PictureKernel& other) { return other.Chosen == chosen; });
  if (kernel == kernels.end())
  {
    throw std::logic_error("no kernel of the CPU reference draws such a picture");
  }
  return std::is_same_v<Real, float> ? kernel->Float(scene, level) : kernel->Double(scene, level);
}

template ReferenceImage renderReference<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderReference<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
