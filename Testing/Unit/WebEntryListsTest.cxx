// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Testing/Web/entry_lists.json: lists by which Testing/Web/entry_lists.test.mjs checks those of
// Web/entry_lists.js. See JsonText.h.
#include "Entries/EntryLists.h"
#include "View/View.h"

#include "JsonText.h"
#include "UnitMeshes.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// All numbers of a view that lists depend on.
struct Case
{
  const char* Name;
  std::array<double, 16> NormalizedToClip;
  bool Mirrored;
  std::array<int, 2> Size;
};

constexpr std::array<double, 16> Perspective{ { 2.0, 0.4, 0.1, 0.05, -0.3, 2.6, 0.2, -0.1, 0.2,
  -0.1, -1.1, 2.0, 0.3, -0.2, -1.0, 3.0 } };
constexpr std::array<double, 16> Parallel{ { 1.1, 0.2, -0.1, 0.02, 0.1, 1.3, 0.3, 0.0, 0.1, -0.2,
  -0.5, 0.0, 0.0, 0.0, 0.0, 1.0 } };
constexpr std::array<double, 16> Mirrored{ { -4.0, -0.8, -0.2, -0.1, -0.6, 5.2, 0.4, -0.2, 0.2,
  -0.1, -1.1, 2.0, 0.3, -0.2, -1.0, 3.0 } };

const Case Cases[] = {
  { "perspective", Perspective, false, { { 97, 71 } } },
  { "parallel", Parallel, false, { { 64, 48 } } },
  { "mirrored, a part of the mesh", Mirrored, true, { { 53, 41 } } },
  { "faces of many tiles", Perspective, false, { { 600, 400 } } },
  { "one pixel", Perspective, false, { { 1, 1 } } },
};

std::string inputOf(const Case& one, const TetMesh& mesh)
{
  return object({ { "view", object({ { "normalizedToClip", json(one.NormalizedToClip) },
                              { "mirrored", json(one.Mirrored) } }) },
    { "halfExtent", json(mesh.Frame.HalfExtent) }, { "size", json(one.Size) } });
}

std::string expectedOf(const Case& one, const TetMesh& mesh)
{
  View view;
  view.NormalizedToClip = one.NormalizedToClip;
  view.Mirrored = one.Mirrored;
  const EntryLists lists = makeEntryLists(mesh, mesh.BoundaryFaces, view, one.Size[0], one.Size[1]);
  std::vector<std::uint32_t> candidates;
  for (const EntryCandidate& candidate : lists.Candidates)
  {
    candidates.insert(candidates.end(), { candidate.Face, candidate.Where });
  }
  return object({ { "tileShift", json(lists.TileShift) },
    { "tilesPerRow", json(lists.TilesPerRow) }, { "depthPlane", json(lists.DepthPlane) },
    { "first", json(lists.First) }, { "candidates", json(candidates) } });
}

TEST(WebEntryLists, AreThoseOfTheFile)
{
  const TetMesh mesh = builtWithHierarchy(latticeWithTunnel(3));
  std::vector<float> vertices;
  for (const Vertex& v : mesh.Vertices)
  {
    vertices.insert(vertices.end(), { v.X, v.Y, v.Z, v.Scalar });
  }
  std::vector<Id> faces;
  for (const auto& face : mesh.BoundaryFaces)
  {
    faces.insert(faces.end(), face.begin(), face.end());
  }
  std::string cases;
  for (const Case& one : Cases)
  {
    cases += (cases.empty() ? "" : ",\n") +
             object({ { "name", json(one.Name) }, { "input", inputOf(one, mesh) },
               { "expected", expectedOf(one, mesh) } });
  }
  expectStored("entry_lists.json",
    "{\"vertices\": " + json(vertices) + ",\n\"faces\": " + json(faces) + ",\n\"cases\": [\n" +
      cases + "\n]}\n",
    "entry_lists.test.mjs");
}
} // namespace
