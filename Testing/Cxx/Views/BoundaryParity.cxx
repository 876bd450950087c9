// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryParity.h"

#include "BoundaryReference.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <iostream>
#include <set>

namespace tetmarch::testing
{
namespace
{
using Mapper = vtkTetMarchVolumeMapper;
using Bytes = std::array<int, 3>;

constexpr Bytes Background{ { 51, 102, 153 } }; // no channel is full: no face has it

// hashOf() and colorOf() are what passes/boundary_view.frag.glsl does.
std::uint32_t hashOf(std::uint32_t number)
{
  const std::uint32_t state = number * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

Bytes colorOf(const std::array<unsigned int, 3>& face)
{
  const std::uint32_t bits = hashOf(face[0] + hashOf(face[1] + hashOf(face[2])));
  const int first = 64 + static_cast<int>(bits & 255u) * 3 / 4;
  const int second = 64 + static_cast<int>(bits >> 8u & 255u) * 3 / 4;
  const Bytes colors[] = { { { 255, first, second } }, { { first, 255, second } },
    { { first, second, 255 } } };
  return colors[(bits >> 16u) % 3u];
}

// Of the renderer's viewport.
std::vector<Bytes> pixelsOf(const Scene& scene, const Image& frame)
{
  const int* size = scene.Renderer->GetSize();
  const int* origin = scene.Renderer->GetOrigin();
  const Image part = cropped(frame, origin[0], origin[1], size[0], size[1]);
  std::vector<Bytes> pixels;
  for (std::size_t i = 0; i < part.Rgba.size(); i += 4)
  {
    Bytes bytes;
    for (int k = 0; k < 3; ++k)
    {
      bytes[k] = static_cast<int>(std::lround(255.0 * double(part.Rgba[i + k])));
    }
    pixels.push_back(bytes);
  }
  return pixels;
}

// Whether the pixel and those around it have an entry: all of them, or none.
Mask whereAll(const std::vector<BoundaryPixel>& reference, int width, bool entered)
{
  const int height = static_cast<int>(reference.size()) / width;
  Mask mask;
  for (int i = 0; i < width * height; ++i)
  {
    bool all = true;
    for (int v = std::max(i / width - 1, 0); v <= std::min(i / width + 1, height - 1); ++v)
    {
      for (int u = std::max(i % width - 1, 0); u <= std::min(i % width + 1, width - 1); ++u)
      {
        all = all && (reference[v * width + u].Face >= 0) == entered;
      }
    }
    mask.push_back(all);
  }
  return mask;
}

bool areBarycentrics(const Bytes& pixel, const Vec3& barycentrics)
{
  bool same = true;
  for (int k = 0; k < 3; ++k)
  {
    same = same && std::abs(pixel[k] - 255.0 * barycentrics[k]) <= 2.0;
  }
  return same;
}
} // namespace

int expectAsReference(BoundaryScene& scene, bool withOpaque)
{
  const std::vector<Bytes> faces = pixelsOf(scene, scene.view(Mapper::VIEW_BOUNDARY_FACES));
  const BoundaryReference reference =
    boundaryViewOf(scene, withOpaque ? scene.windowDepths() : std::vector<float>());
  const std::vector<Bytes> places = pixelsOf(scene, scene.view(Mapper::VIEW_BOUNDARY_COORDINATES));
  std::set<Bytes> colors;
  for (const auto& face : reference.Faces)
  {
    colors.insert(colorOf(face));
  }
  const Mask inside = whereAll(reference.Pixels, scene.Renderer->GetSize()[0], true);
  const Mask outside = whereAll(reference.Pixels, scene.Renderer->GetSize()[0], false);
  int compared = 0, otherFace = 0, otherPlace = 0, noColor = 0, noSum = 0, kept = 0;
  for (std::size_t i = 0; i < reference.Pixels.size(); ++i)
  {
    const int sum = places[i][0] + places[i][1] + places[i][2];
    if (inside[i])
    {
      ++compared;
      noColor += colors.count(faces[i]) == 0;
      noSum += std::abs(sum - 255) > 1;
      otherFace += faces[i] != colorOf(reference.Faces[reference.Pixels[i].Face]);
      otherPlace += !areBarycentrics(places[i], reference.Pixels[i].Barycentrics);
    }
    else if (outside[i])
    {
      // Opaque geometry has colours of its own.
      kept += withOpaque ? colors.count(faces[i]) != 0
                         : faces[i] != Background || places[i] != Background;
    }
    else
    {
      noColor += faces[i] != Background && !withOpaque && colors.count(faces[i]) == 0;
    }
  }
  EXPECT_EQ(noColor, 0);
  EXPECT_EQ(noSum, 0);
  EXPECT_EQ(kept, 0) << "something outside";
  EXPECT_LE(otherFace, compared / 1000);
  EXPECT_LE(otherPlace, compared / 1000);
  std::cout << "[ MEASURED ] inside " << compared
            << " pixels, another face than the reference's in " << otherFace
            << ", another place in " << otherPlace << '\n';
  return compared;
}
} // namespace tetmarch::testing
