// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parity.h"

#include "Failure.h"
#include "GL/ComputeDispatch.h"
#include "Images.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkTable.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolume.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::json;
using testing::Image;
using testing::Mask;

// So many pixels have one ray that the CPU marches in float, each for several milliseconds.
constexpr std::size_t PixelsPerRay = 64;

Image imageOf(vtkFloatArray* pixels, const int* size)
{
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1] ||
      pixels->GetNumberOfComponents() != 4)
  {
    throw Failure("the picture can't be read back in float");
  }
  return Image::fromFloats(size[0], size[1], pixels->GetPointer(0));
}

Mask finitePixels(const Image& picture)
{
  Mask finite(picture.Rgba.size() / 4);
  for (std::size_t i = 0; i < finite.size(); ++i)
  {
    finite[i] = std::all_of(picture.Rgba.begin() + 4 * i, picture.Rgba.begin() + 4 * i + 4,
      [](float channel) { return std::isfinite(channel); });
  }
  return finite;
}

/// Null if there is no pixel.
Json differences(const Image& drawn, const Image& truth, const Mask& mask)
{
  const testing::Difference difference = testing::compare(drawn, truth, mask);
  if (difference.Pixels == 0)
  {
    return nullptr;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < drawn.Rgba.size(); ++i)
  {
    const auto here = static_cast<double>(drawn.Rgba[i]);
    sum += mask[i / 4] ? std::abs(here - static_cast<double>(truth.Rgba[i])) : 0.0;
  }
  return { { "max", difference.Max },
    { "mean", sum / (4.0 * static_cast<double>(difference.Pixels)) },
    { "p999", difference.Percentile999 }, { "pixels", difference.Pixels },
    { "worst_pixel", { difference.WorstX, difference.WorstY } } };
}

Image groundTruth(vtkTetMarchVolumeMapper* mapper, vtkVolume* volume, const Image& drawn)
{
  vtkNew<vtkFloatArray> pixels;
  if (!mapper->RenderGroundTruth(volume, pixels))
  {
    throw Failure("the CPU has no picture of this frame");
  }
  const int size[2] = { drawn.Width, drawn.Height };
  return imageOf(pixels, size);
}

/// Some of them at even distances, row by row.
std::vector<int> someOf(const Mask& mask)
{
  const auto all = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), true));
  const std::size_t step = all / (mask.size() / PixelsPerRay + 1) + 1;
  std::vector<int> pixels;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (mask[i] && seen++ % step == 0)
    {
      pixels.push_back(static_cast<int>(i));
    }
  }
  return pixels;
}

Json againstCpu(vtkTetMarchVolumeMapper* mapper, vtkVolume* volume, const Image& drawn,
  const std::vector<int>& pixels)
{
  Image marched(drawn.Width, drawn.Height);
  Mask mask(drawn.Rgba.size() / 4);
  vtkNew<vtkTable> cells;
  for (const int pixel : pixels)
  {
    const int x = pixel % drawn.Width;
    const int y = pixel / drawn.Width;
    if (!mapper->TraceRay(volume, x, y, vtkTetMarchVolumeMapper::TRACE_FLOAT, cells))
    {
      throw Failure("the CPU can't march a ray of this frame");
    }
    const double* color = cells->GetFieldData()->GetArray("Color")->GetTuple(0);
    std::copy(color, color + 4, marched.pixel(x, y));
    mask[pixel] = true;
  }
  return differences(drawn, marched, mask);
}

/// The picture as the march counted it, in float.
Image countedPicture(vtkRenderWindow* window, vtkTetMarchVolumeMapper* mapper)
{
  mapper->CollectDiagnosticsOn();
  window->Render();
  mapper->CollectDiagnosticsOff();
  vtkNew<vtkFloatArray> pixels;
  mapper->GetDiagnosticPixels(pixels);
  return imageOf(pixels, window->GetSize());
}

/// By compute shaders; nothing where the GL has none.
std::optional<Image> pictureByCompute(vtkRenderWindow* window, vtkTetMarchVolumeMapper* mapper)
{
  window->Render();
  if (!computeSupport().Exists)
  {
    return std::nullopt;
  }
  mapper->SetShaderStageToCompute();
  return countedPicture(window, mapper);
}
} // namespace

Json measureParity(vtkRenderWindow* window, vtkTetMarchVolumeMapper* mapper, vtkVolume* volume)
{
  const std::optional<Image> computed = pictureByCompute(window, mapper);
  mapper->SetShaderStageToFragment();
  const Image drawn = countedPicture(window, mapper);
  const Mask finite = finitePixels(drawn);
  const Image truth = groundTruth(mapper, volume, drawn);
  Mask covered = testing::silhouette(drawn, truth);
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    covered[i] = covered[i] && finite[i];
  }
  return { { "tolerance", mapper->GetUsedErrorTolerance() },
    { "ground_truth", differences(drawn, truth, covered) },
    { "cpu", againstCpu(mapper, volume, drawn, someOf(covered)) },
    { "compute", computed ? differences(drawn, *computed, covered) : Json(nullptr) },
    { "pixels_not_finite", std::count(finite.begin(), finite.end(), false) },
    { "rays", mapper->GetNumberOfRays() }, { "crossed_cells", mapper->GetNumberOfCrossedCells() },
    { "lookups", mapper->GetNumberOfLookups() },
    { "refused_entries", mapper->GetNumberOfRefusedEntries() },
    { "lost_rays", mapper->GetNumberOfLostRays() },
    { "guard_hits", mapper->GetNumberOfGuardHits() } };
}
} // namespace tetmarch::bench
