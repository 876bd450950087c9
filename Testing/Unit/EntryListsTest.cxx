// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// By its list each pixel's ray finds the entries that a search in the hierarchy finds: all of them,
// each once, in the same order.
#include "Entries/EnteredPixels.h"
#include "Entries/EntryListMaker.h"

#include "Reference/ListKernel.h"
#include "Reference/PortableListKernel.h"
#include "View/RayPoints.h"

#include "NamedCamera.h"
#include "PixelLists.h"
#include "Shot.h"
#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr PictureSize Picture{ 97, 71 };
constexpr int Width = Picture.Width;
constexpr int Height = Picture.Height;
constexpr std::uint64_t NoLimit = std::uint64_t(1) << 32;

// Of meshes within the unit cube, or about as large.
const NamedCamera Cameras[] = {
  { "from afar", [](vtkCamera* camera, vtkTransform*) { camera->SetPosition(2.1, 1.4, 2.9); } },
  { "from nearby, at a wide angle",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(1.3, 1.6, 1.9);
      camera->SetViewAngle(110.0);
    } },
  { "a small part, from near a side",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(0.47, 2.4, 0.52);
      camera->SetViewAngle(2.0);
    } },
  { "along an axis, parallel",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(0.5, 0.5, 5.0);
      camera->ParallelProjectionOn();
      camera->SetParallelScale(0.6);
    } },
  { "at a million times its size",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(1e6, 2e6, 3e6);
      camera->SetViewAngle(3e-5);
    } },
  { "sheared, as for an eye of a stereo picture",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(2.1, 1.4, 2.9);
      camera->SetViewShear(0.2, -0.1, 1.0);
    } },
  { "turned and mirrored",
    [](vtkCamera* camera, vtkTransform* transform)
    {
      camera->SetPosition(4.0, -5.0, 7.0);
      transform->RotateWXYZ(50.0, 0.3, 1.0, -0.2);
      transform->Scale(1.0, -2.0, 3.0);
    } },
};

// All of the mesh lies before the eye, but that is what the lists need, and no near plane.
View viewOf(const NamedCamera& camera, const TetMesh& mesh)
{
  Shot shot;
  shot.Camera->SetFocalPoint(0.5, 0.5, 0.5);
  shot.Camera->SetViewUp(0.1, 1.0, 0.2);
  camera.Set(shot.Camera, shot.Transform);
  shot.Camera->SetClippingRange(1e-3, 1e9);
  return viewOf(shot, mesh);
}

struct Found
{
  int Entries = 0;
  int Most = 0; // of a ray
  std::size_t Candidates = 0;
  std::size_t Views = 0;
};

template <typename Kernel>
void expectSameEntries(
  const TetMesh& mesh, const View& view, Found& found, std::uint64_t mostTexels = NoLimit)
{
  Kernel kernel;
  kernel.useMesh(mesh);
  const EntryLists lists =
    EntryListMaker().make(mostTexels, mesh, mesh.BoundaryFaces, view, Width, Height);
  ASSERT_LE(lists.First.size(), mostTexels);
  ASSERT_LE(lists.Candidates.size(), mostTexels);
  const std::array<double, 16> points = rayPoints(view, mesh.Frame);
  found.Candidates += lists.Candidates.size();
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      auto ray = rayOf(kernel, view, points, Picture, column, row);
      useList(kernel, lists, column, row, ray);
      typename Kernel::Entry listed{ -float(NoDepth), -1 };
      typename Kernel::Entry searched = listed;
      int candidate = ray.firstCandidate;
      int entries = 0;
      do
      {
        listed = kernel.nextCandidate(ray, listed, candidate);
        searched = kernel.nextEntry(ray, searched, true);
        ASSERT_EQ(listed.face, searched.face) << column << ", " << row << ": entry " << entries;
        ASSERT_EQ(listed.depth, searched.depth) << column << ", " << row << ": entry " << entries;
        ++entries;
      } while (searched.face >= 0);
      found.Entries += entries - 1;
      found.Most = std::max(found.Most, entries - 1);
    }
  }
}

TEST(EntryLists, HaveWhatASearchFinds)
{
  for (const NamedCamera& camera : Cameras)
  {
    Found found;
    for (const NamedGrid& named : everyGrid())
    {
      SCOPED_TRACE(std::string(camera.Name) + ", " + named.Name);
      const TetMesh mesh = builtWithHierarchy(named.Make());
      const View view = viewOf(camera, mesh);
      if (!view.CutsNearPlane)
      {
        ASSERT_NO_FATAL_FAILURE(expectSameEntries<ListKernel<float>>(mesh, view, found));
        ASSERT_NO_FATAL_FAILURE(expectSameEntries<PortableListKernel<float>>(mesh, view, found));
        ++found.Views;
      }
    }
    std::cout << "[ MEASURED ] " << camera.Name << ": " << found.Entries << " entries, "
              << found.Most << " of a ray; " << found.Candidates << " candidates\n";
    EXPECT_GT(found.Entries, 5000) << camera.Name;
    EXPECT_GT(found.Most, 1) << camera.Name;
    EXPECT_GE(found.Views, everyGrid().size() - 2) << camera.Name;
  }
}

// Faces of a fraction of a pixel, and of several pixels: tiles of all sizes.
TEST(EntryLists, InTilesOfAnySize)
{
  std::set<int> shifts;
  for (const int cubes : { 3, 6, 12, 24 })
  {
    const TetMesh mesh = builtWithHierarchy(latticeWithTunnel(cubes));
    for (const double angle : { 60.0, 20.0, 6.0, 2.0, 0.2 })
    {
      const NamedCamera narrow{ "", [angle](vtkCamera* camera, vtkTransform*)
        {
          camera->SetPosition(2.1, 1.4, 2.9);
          camera->SetViewAngle(angle);
        } };
      const View view = viewOf(narrow, mesh);
      shifts.insert(makeEntryLists(mesh, mesh.BoundaryFaces, view, Width, Height).TileShift);
      Found found;
      ASSERT_NO_FATAL_FAILURE(expectSameEntries<ListKernel<float>>(mesh, view, found));
      EXPECT_GT(found.Entries, 0);
    }
  }
  EXPECT_EQ(shifts, (std::set<int>{ 0, 1, 2, 3, 4 }));
}

// A GL may take few texels in a buffer: tiles grow up to the whole picture.
TEST(EntryLists, FitAnyLimit)
{
  std::set<int> shifts;
  const TetMesh mesh = builtWithHierarchy(latticeWithTunnel(12));
  for (const NamedCamera& camera : Cameras)
  {
    const View view = viewOf(camera, mesh);
    const auto lists = [&](std::uint64_t most)
    { return EntryListMaker().make(most, mesh, mesh.BoundaryFaces, view, Width, Height); };
    const std::uint64_t least = std::max<std::size_t>(lists(1).Candidates.size(), 2);
    for (const std::uint64_t most : { least, 5 * least / 4, 3 * least / 2, 2 * least })
    {
      shifts.insert(lists(most).TileShift);
      Found found;
      ASSERT_NO_FATAL_FAILURE(expectSameEntries<ListKernel<float>>(mesh, view, found, most))
        << camera.Name << ", " << most;
      EXPECT_GT(found.Entries, 0);
    }
  }
  EXPECT_EQ(*shifts.rbegin(), 7) << "one tile, told apart by squares of 8 x 8 pixels";
}

// Whoever sees a convex mesh has one entry; a list has few candidates that are in vain.
TEST(EntryLists, AreShort)
{
  const TetMesh mesh = builtWithHierarchy(jitteredLattice(20));
  const View view = viewOf(Cameras[0], mesh);
  Found found;
  ASSERT_NO_FATAL_FAILURE(expectSameEntries<ListKernel<float>>(mesh, view, found));
  EXPECT_EQ(found.Most, 1);
  EXPECT_LT(found.Candidates, 4u * Width * Height);
}

// The order of candidates does not depend on which thread is quicker.
TEST(EntryLists, AreTheSameEachTime)
{
  const TetMesh mesh = builtWithHierarchy(latticeWithTunnel(12));
  const View view = viewOf(Cameras[1], mesh);
  const EntryLists first = makeEntryLists(mesh, mesh.BoundaryFaces, view, 300, 200);
  for (int i = 0; i < 5; ++i)
  {
    const EntryLists again = makeEntryLists(mesh, mesh.BoundaryFaces, view, 300, 200);
    ASSERT_EQ(again.First, first.First);
    for (std::size_t k = 0; k < first.Candidates.size(); ++k)
    {
      ASSERT_EQ(again.Candidates[k].Face, first.Candidates[k].Face);
      ASSERT_EQ(again.Candidates[k].Where, first.Candidates[k].Where);
    }
  }
}

TEST(EntryLists, OfOnePixel)
{
  const TetMesh mesh = builtWithHierarchy(jitteredLattice(3));
  const EntryLists lists = makeEntryLists(mesh, mesh.BoundaryFaces, viewOf(Cameras[0], mesh), 1, 1);
  EXPECT_GE(lists.Candidates.size(), 1u);
  EXPECT_EQ(lists.First, (std::vector<std::uint32_t>{ 0, std::uint32_t(lists.Candidates.size()) }));
}

TEST(EntryLists, AreEmptyBesideThePicture)
{
  const TetMesh mesh = builtWithHierarchy(jitteredLattice(3));
  const NamedCamera beside{ "", [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(2.1, 1.4, 2.9);
      camera->SetFocalPoint(2.1, 8.0, -9.0);
    } };
  const auto lists = makeEntryLists(mesh, mesh.BoundaryFaces, viewOf(beside, mesh), 8, 8);
  EXPECT_TRUE(lists.Candidates.empty());
  EXPECT_EQ(enteredPixels(lists).Right, 0);
}

TEST(EntryLists, AreWithinTheEnteredPixels)
{
  // Six tiles in a row, each of 4 x 4 pixels, in four rows.
  EntryLists lists;
  lists.TileShift = 2;
  lists.TilesPerRow = 6;
  lists.First.assign(25, 0);
  for (const std::size_t tile : { 6 + 2, 6 + 3, 12 + 1, 12 + 4 })
  {
    std::for_each(lists.First.begin() + tile + 1, lists.First.end(), [](auto& first) { ++first; });
  }
  const EnteredPixels entered = enteredPixels(lists);
  EXPECT_EQ(entered.Left, 4);
  EXPECT_EQ(entered.Bottom, 4);
  EXPECT_EQ(entered.Right, 20);
  EXPECT_EQ(entered.Top, 12);
}
} // namespace
