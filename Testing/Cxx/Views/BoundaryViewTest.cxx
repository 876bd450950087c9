// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The view modes of the boundary: each pixel shows by which face its ray enters, and where.
#include "BoundaryReference.h"
#include "BoundaryScene.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <iostream>
#include <set>

namespace
{
using namespace tetmarch::testing;
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

// Returns how many pixels inside the silhouette of the boundary were compared. Where the
// rasteriser, or float, takes the face beside the reference's, the pixel is on an edge of both:
// rarely.
int expectAsReference(BoundaryScene& scene, bool withOpaque = false)
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

TEST(BoundaryView, IsAsTheReferenceHasIt)
{
  for (const int samples : { 0, 8 })
  {
    BoundaryScene scene(boundaryLattice());
    scene.Window->SetMultiSamples(samples);
    EXPECT_GT(expectAsReference(scene), 4000);
  }
  BoundaryScene parallel(boundaryLattice());
  parallel.camera()->ParallelProjectionOn();
  parallel.camera()->SetParallelScale(0.9);
  EXPECT_GT(expectAsReference(parallel), 4000);
  BoundaryScene mirrored(boundaryLattice());
  mirrored.Volume->SetScale(-1.0, 1.0, 1.0);
  mirrored.Volume->SetPosition(1.0, 0.0, 0.0);
  EXPECT_GT(expectAsReference(mirrored), 4000);
}

TEST(BoundaryView, OfNonConvexMeshes)
{
  for (const Grid& grid : { latticeWithHole(6), latticeWithTunnel(6), lShape(6), twoComponents(6) })
  {
    BoundaryScene scene(grid);
    EXPECT_GT(expectAsReference(scene), 2000);
  }
}

TEST(BoundaryView, InAViewportOffTheCorner)
{
  BoundaryScene scene(latticeWithHole(6), 240, 200);
  scene.Renderer->SetViewport(0.3, 0.15, 0.95, 0.9);
  EXPECT_GT(expectAsReference(scene), 4000);
  scene.camera()->SetClippingRange(2.4, 10.0); // searched for
  EXPECT_GT(expectAsReference(scene), 4000);
}

// The near plane cuts the mesh: pixels show the face behind the camera by which the ray entered or,
// if the camera is in the hole, the next face that it enters by.
TEST(BoundaryView, CameraInside)
{
  BoundaryScene scene(latticeWithHole(6));
  scene.camera()->SetClippingRange(0.01, 5.0);
  const Vec3 places[] = { { { 0.05, 0.42, 0.57 } }, { { 0.52, 0.49, 0.48 } } };
  for (const Vec3& place : places)
  {
    scene.camera()->SetPosition(place.data());
    scene.camera()->SetFocalPoint(1.0, 0.55, 0.45);
    EXPECT_EQ(expectAsReference(scene), SceneSize * SceneSize);
  }
}

// In the box about the mesh, but not in the mesh: nothing of what lies behind is seen.
TEST(BoundaryView, CameraBetween)
{
  BoundaryScene scene(lShape(6));
  scene.camera()->SetClippingRange(0.001, 5.0);
  scene.camera()->SetPosition(0.8, 0.8, 0.5);
  int inside[2];
  for (int away = 0; away < 2; ++away)
  {
    scene.camera()->SetFocalPoint(away ? 1.8 : 0.2, away ? 1.8 : 0.2, 0.55);
    inside[away] = expectAsReference(scene);
  }
  EXPECT_GT(inside[0], 1000);
  EXPECT_LT(inside[1], inside[0]);
}

// The first cut of the near plane makes the hierarchy, which numbers faces anew: colours stay.
TEST(BoundaryView, NearPlaneChangesNoColor)
{
  BoundaryScene scene(boundaryLattice());
  const Image before = scene.view(Mapper::VIEW_BOUNDARY_FACES);
  scene.camera()->SetClippingRange(2.4, 10.0);
  EXPECT_LE(compare(scene.view(Mapper::VIEW_BOUNDARY_FACES), before).Over, 20u);
}

TEST(BoundaryView, OpaqueGeometryHidesWhatIsBehind)
{
  for (const Grid& grid : { boundaryLattice(), latticeWithHole(6) })
  {
    BoundaryScene scene(grid);
    const int whole = expectAsReference(scene);
    const auto ball = makeBall({ 0.5, 0.95, 0.9 }, 0.3, { 0.1, 0.1, 0.1 });
    scene.Renderer->AddActor(ball);
    const int before = expectAsReference(scene, true);
    EXPECT_GT(before, whole / 3);
    EXPECT_LT(before, whole - 500);
    scene.camera()->SetClippingRange(2.4, 10.0); // searched for
    EXPECT_LT(expectAsReference(scene, true), whole - 500);
    scene.camera()->SetClippingRange(0.5, 10.0);
    scene.Renderer->RemoveActor(ball);
    // What is inside hides nothing.
    const Image alone = scene.view(Mapper::VIEW_BOUNDARY_FACES);
    scene.Renderer->AddActor(makeBall({ 0.5, 0.5, 0.5 }, 0.3, { 0.1, 0.1, 0.1 }));
    EXPECT_EQ(compare(scene.view(Mapper::VIEW_BOUNDARY_FACES), alone).Max, 0.0);
  }
}
} // namespace
