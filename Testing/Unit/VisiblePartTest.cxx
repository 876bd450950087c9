// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays that enter and leave the visible part alone see what they see of the whole mesh.
#include "Entries/VisiblePartFinder.h"

#include "Entries/EntryLists.h"
#include "Mesh/CurvilinearMesh.h"
#include "Mesh/TetMeshBuilder.h"
#include "Reference/PartKernel.h"
#include "Reference/PointKernel.h"

#include "CurvilinearGrids.h"
#include "RandomRays.h"
#include "SeenWaves.h"
#include "UnitMeshes.h"

#include "vtkStructuredGrid.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

bool bitOf(const std::vector<std::uint32_t>& bits, Id tet)
{
  return (bits[tet / 32] >> (tet % 32) & 1u) != 0;
}

struct Part
{
  explicit Part(const TetMesh& mesh, const IntegralTable& table)
  {
    this->Scalars.Range = { 0, 1, true };
    this->Found = findVisiblePart(
      mesh, { &this->Scalars, &table, &this->Blend, &this->Hidden, this->UndrawnSeen });
  }

  MeshScalars Scalars;
  Blending Blend;
  HiddenCells Hidden;
  bool UndrawnSeen = false;
  VisiblePart Found;
};

// For any ray: each face is a candidate.
EntryLists allOf(const VisiblePart& part)
{
  EntryLists lists;
  for (std::size_t face = 0; face < part.Faces.size(); ++face)
  {
    lists.Candidates.push_back({ static_cast<std::uint32_t>(face), 0xf0f0u });
  }
  return lists;
}

// Rays pass through tetrahedra without volume at poles, whatever is seen; none enters there.
TEST(VisiblePart, LetsRaysThroughPoles)
{
  const Movement ofAxis = [](const std::array<double, 3>& p) {
    return std::array<double, 3>{ p[0] * std::cos(5 * p[1]), p[0] * std::sin(5 * p[1]), p[2] };
  };
  TetMesh mesh;
  std::string error;
  buildCurvilinearMesh(curvilinearGrid({ 4, 9, 5 }, ofAxis), {}, true, mesh, error);
  ASSERT_TRUE(mesh.Curvilinear);
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = v.Z > 0 ? 0.9f : 0.1f;
  }
  const VisiblePart part = Part(mesh, highTable()).Found;
  EXPECT_FALSE(part.Faces.empty());
  int degenerate = 0;
  for (Id tet = 0; tet < mesh.numberOfTets(); ++tet)
  {
    degenerate += mesh.isDegenerate(tet) ? 1 : 0;
    EXPECT_TRUE(!mesh.isDegenerate(tet) || bitOf(part.Tets, tet)) << tet;
  }
  EXPECT_EQ(degenerate, 9 * 5 * 3);
  for (const std::array<Id, 4>& face : part.Faces)
  {
    EXPECT_FALSE(mesh.isDegenerate(face[3] / 4));
  }
}

// Tetrahedra by what their vertices show, and all faces between them and others.
TEST(VisiblePart, HasTheFacesOfWhatIsSeen)
{
  const IntegralTable table = highTable();
  int parts = 0;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    TetMesh mesh = builtWithHierarchy(named.Make());
    setWaves(mesh);
    const VisiblePart part = Part(mesh, table).Found;
    std::size_t seen = 0;
    std::size_t faces = 0;
    for (Id tet = 0; tet < mesh.numberOfTets(); ++tet)
    {
      bool isSeen = false;
      for (const Id id : mesh.Tets[tet])
      {
        isSeen = isSeen || mesh.Vertices[id].Scalar > 0.8005f;
        ASSERT_TRUE(bitOf(part.Tets, tet) || mesh.Vertices[id].Scalar <= 0.8005f);
      }
      seen += bitOf(part.Tets, tet) ? 1 : 0;
      for (Id i = 0; i < 4; ++i)
      {
        const Id link = mesh.Links[4 * tet + i];
        faces +=
          bitOf(part.Tets, tet) && (link >= LinkOutside || !bitOf(part.Tets, link / 4)) ? 1 : 0;
      }
    }
    EXPECT_EQ(part.NumberOfTets, seen);
    if (seen == 0 || seen == mesh.Tets.size())
    {
      EXPECT_TRUE(part.Faces.empty());
      continue;
    }
    ++parts;
    ASSERT_EQ(part.Faces.size(), faces);
    for (const auto& face : part.Faces)
    {
      // The half-face is that of a tetrahedron of the part, opposite the vertex that the face
      // lacks.
      ASSERT_LT(face[3], 4 * mesh.numberOfTets());
      ASSERT_TRUE(bitOf(part.Tets, face[3] / 4));
      const auto& ids = mesh.Tets[face[3] / 4];
      for (int i = 0; i < 3; ++i)
      {
        ASSERT_NE(std::find(ids.begin(), ids.end(), face[i]), ids.end());
        ASSERT_NE(face[i], ids[face[3] % 4]);
      }
    }
  }
  EXPECT_GT(parts, 10);
}

// Every kind of ray through every grid, in both arithmetics.
template <typename Real>
void expectSameOnEveryRay(const TetMesh& mesh, const IntegralTable& table, const VisiblePart& part,
  Real tolerance, std::array<std::int64_t, 2>& cells)
{
  auto whole = kernelOf<PointKernel<Real>, Real>(mesh, table, DefaultAccuracy);
  const auto& none = TableTraits::NothingTransparent;
  whole.transparentRanges = { none[0], none[1], none[2], none[3] };
  auto kernel = kernelOf<PartKernel<Real>, Real>(mesh, table, DefaultAccuracy);
  const EntryLists lists = allOf(part);
  kernel.useEntryLists(lists);
  kernel.Part = &part;
  RandomRays random(5);
  for (int i = 0; i < 1500; ++i)
  {
    const auto ray = random.next<PointKernel<Real>, Real>(whole, mesh);
    auto same = kernel.rayThrough(ray.origin, ray.direction);
    same.origin = ray.origin;
    same.firstCandidate = 0;
    same.endOfCandidates = static_cast<int>(lists.Candidates.size());
    same.pixelInTile = 0;
    const auto expected = whole.castPlainRay(ray, Real(3), Real(-3e38f), Real(3e38f));
    const auto found = kernel.castPlainRay(same, Real(3), Real(-3e38f), Real(3e38f));
    ASSERT_NEAR(found.radiance.color.x, expected.radiance.color.x, tolerance) << i;
    ASSERT_NEAR(found.radiance.color.y, expected.radiance.color.y, tolerance) << i;
    ASSERT_NEAR(found.radiance.transmittance, expected.radiance.transmittance, tolerance) << i;
    ASSERT_EQ(found.lost, 0) << i;
    ASSERT_EQ(found.refused, 0) << i;
    ASSERT_LE(found.cells, expected.cells) << i;
    cells[0] += found.cells;
    cells[1] += expected.cells;
  }
}

TEST(VisiblePart, ShowsWhatTheWholeMeshShows)
{
  const IntegralTable table = highTable();
  std::array<std::int64_t, 2> cells{};
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    TetMesh mesh = builtWithHierarchy(named.Make());
    setWaves(mesh);
    const VisiblePart part = Part(mesh, table).Found;
    if (!part.Faces.empty())
    {
      ASSERT_NO_FATAL_FAILURE(expectSameOnEveryRay<float>(mesh, table, part, 1e-4f, cells));
      ASSERT_NO_FATAL_FAILURE(expectSameOnEveryRay<double>(mesh, table, part, 1e-9, cells));
    }
  }
  std::cout << "[ MEASURED ] " << cells[0] << " cells instead of " << cells[1] << '\n';
  EXPECT_GT(cells[0], 10000);
  EXPECT_LT(2 * cells[0], cells[1]);
}

// An interval of scalars that is visible, between two that are not.
IntegralTable tableBetween(double low, double high)
{
  return tableOf(
    [=](double f) {
      return std::array<double, 4>{ { f, 1.0 - f, 0.5, low <= f && f <= high ? 5.0 : 0.0 } };
    });
}

// Of every grid, with and without hidden cells and scalars that are not finite.
TEST(VisiblePart, AfterEditsIsThatOfTheLastOne)
{
  std::mt19937 generator(3);
  int edits = 0;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    TetMesh mesh = builtWithHierarchy(named.Make());
    setWaves(mesh);
    VisiblePartFinder finder;
    Part shown(mesh, highTable());
    for (std::uintptr_t edit = 0; edit < 24; ++edit)
    {
      if (edit == 8)
      {
        shown.Hidden.assign((mesh.Tets.size() + 31) / 32, 0x10204080u);
      }
      if (edit == 16)
      {
        mesh.Vertices[mesh.Vertices.size() / 2].Scalar = UndrawnScalar;
      }
      const double low = uniform(generator);
      const IntegralTable table = tableBetween(low, low + 0.3 * uniform(generator));
      shown.UndrawnSeen = edit % 2 == 0;
      shown.Blend.Mode = edit % 3 == 2 ? BlendMode::IsoSurface : BlendMode::Composite;
      shown.Blend.IsoValues = { float(low), float(low + 0.01) };
      const VisibleScalars what{ &shown.Scalars, &table, &shown.Blend, &shown.Hidden,
        shown.UndrawnSeen };
      const Fingerprint version{ 1, edit / 8 };
      EXPECT_FALSE(finder.isCurrent(what, version));
      finder.update(mesh, what, version);
      EXPECT_TRUE(finder.isCurrent(what, version));
      const VisiblePart expected = findVisiblePart(mesh, what);
      ASSERT_EQ(finder.part().Tets, expected.Tets);
      ASSERT_EQ(finder.part().NumberOfTets, expected.NumberOfTets);
      ASSERT_EQ(finder.part().Faces, expected.Faces);
      ASSERT_EQ(finder.part().Links, expected.Links);
      ASSERT_EQ(finder.part().CellsOfGap, expected.CellsOfGap);
      edits += expected.Faces.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(edits, 100);
}

// Other colours show the same tetrahedra.
TEST(VisiblePart, IsCurrentWhateverItsColours)
{
  TetMesh mesh = built(jitteredLattice(4));
  setWaves(mesh);
  const IntegralTable table = highTable();
  Part shown(mesh, table);
  const auto with = [&](const IntegralTable& of) {
    return VisibleScalars{ &shown.Scalars, &of, &shown.Blend, &shown.Hidden, false };
  };
  VisiblePartFinder finder;
  finder.update(mesh, with(table), { 1 });
  IntegralTable other = table;
  for (auto& entry : other.Values)
  {
    entry = { { 0.1f, 0.2f, 0.3f, 2 * entry[3] } };
  }
  EXPECT_TRUE(finder.isCurrent(with(other), { 1 }));
  EXPECT_FALSE(finder.isCurrent(with(other), { 2 }));
  EXPECT_FALSE(finder.isCurrent(with(tableBetween(0.2, 0.4)), { 1 }));
}

// The hierarchy of a convex mesh is built when it is needed, and gives boundary faces new numbers.
TEST(VisiblePart, FollowsTheNumbersOfTheBoundary)
{
  TetMesh mesh = built(jitteredLattice(6));
  ASSERT_FALSE(mesh.hasHierarchy());
  setWaves(mesh);
  const IntegralTable table = highTable();
  VisiblePart part = Part(mesh, table).Found;
  const auto before = mesh.BoundaryFaces;
  ensureHierarchy(mesh);
  ASSERT_NE(mesh.BoundaryFaces, before);
  EXPECT_NE(part.Links, Part(mesh, table).Found.Links);
  linkVisiblePart(mesh, part);
  EXPECT_EQ(part.Links, Part(mesh, table).Found.Links);
  EXPECT_EQ(part.Faces, Part(mesh, table).Found.Faces);
}

// What is hidden is not visible, what is not finite only if it has a colour.
TEST(VisiblePart, OfHiddenAndUndrawnCells)
{
  TetMesh mesh = builtWithHierarchy(jitteredLattice(4));
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = 0.9f;
  }
  const IntegralTable table = highTable();
  Part part(mesh, table);
  EXPECT_EQ(part.Found.NumberOfTets, mesh.Tets.size());
  EXPECT_TRUE(part.Found.Faces.empty());

  part.Hidden.assign((mesh.Tets.size() + 31) / 32, 0x80000001u);
  const auto find = [&]
  {
    return findVisiblePart(
      mesh, { &part.Scalars, &table, &part.Blend, &part.Hidden, part.UndrawnSeen });
  };
  EXPECT_EQ(find().NumberOfTets, mesh.Tets.size() - 2 * part.Hidden.size());
  part.Hidden.clear();

  const Id spoilt = mesh.Tets[7][2];
  mesh.Vertices[spoilt].Scalar = UndrawnScalar;
  std::size_t touching = 0;
  for (const auto& tet : mesh.Tets)
  {
    touching += std::find(tet.begin(), tet.end(), spoilt) != tet.end() ? 1 : 0;
  }
  EXPECT_EQ(find().NumberOfTets, mesh.Tets.size() - touching);
  part.UndrawnSeen = true;
  EXPECT_EQ(find().NumberOfTets, mesh.Tets.size());
}

TEST(VisiblePart, OfSurfacesAndOfCells)
{
  TetMesh mesh = builtWithHierarchy(jitteredLattice(4));
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = v.X > 0 ? 0.7f : 0.2f;
  }
  const IntegralTable table = highTable();
  Part part(mesh, table);
  EXPECT_EQ(part.Found.NumberOfTets, 0u);
  part.Blend.Mode = BlendMode::IsoSurface;
  part.Blend.IsoValues = { 0.5f };
  const auto find = [&]
  {
    return findVisiblePart(
      mesh, { &part.Scalars, &table, &part.Blend, &part.Hidden, part.UndrawnSeen });
  };
  std::size_t crossed = 0;
  for (const auto& tet : mesh.Tets)
  {
    int high = 0;
    for (const Id id : tet)
    {
      high += mesh.Vertices[id].Scalar > 0.5f ? 1 : 0;
    }
    crossed += high > 0 && high < 4 ? 1 : 0;
  }
  EXPECT_GT(crossed, 0u);
  EXPECT_EQ(find().NumberOfTets, crossed);

  part.Blend.Mode = BlendMode::Composite;
  part.Scalars.OfCells.assign(mesh.Tets.size(), 0.1f);
  part.Scalars.OfCells[3] = part.Scalars.OfCells[40] = 0.95f;
  EXPECT_EQ(find().NumberOfTets, 2u);
}

TEST(VisiblePart, IsWorthEnteringIfItIsNothing)
{
  TetMesh mesh = builtWithHierarchy(jitteredLattice(3));
  const IntegralTable table = highTable();
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = 0.1f;
  }
  const VisiblePart part = Part(mesh, table).Found;
  EXPECT_TRUE(showsNothing(part));
  EXPECT_TRUE(isWorthEntering(part));
  EXPECT_TRUE(part.Faces.empty());
  EXPECT_FALSE(showsNothing(VisiblePart())); // it was not found
  EXPECT_FALSE(isWorthEntering(VisiblePart()));
}

// A half of the cells beside each other is worth entering, every other one isn't.
TEST(VisiblePart, IsWorthEnteringIfGapsAreLong)
{
  TetMesh mesh = builtWithHierarchy(jitteredLattice(8));
  const IntegralTable table = highTable();
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = v.X > 0 ? 0.9f : 0.2f;
  }
  EXPECT_TRUE(isWorthEntering(Part(mesh, table).Found));
  Part scattered(mesh, table);
  scattered.Scalars.OfCells.resize(mesh.Tets.size());
  for (std::size_t tet = 0; tet < mesh.Tets.size(); ++tet)
  {
    scattered.Scalars.OfCells[tet] = tet % 2 == 0 ? 0.9f : 0.1f;
  }
  EXPECT_FALSE(isWorthEntering(findVisiblePart(
    mesh, { &scattered.Scalars, &table, &scattered.Blend, &scattered.Hidden, false })));
}
} // namespace
