// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/EntryListLimit.h"

#include "Entries/Footprint.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// More tiles or candidates would exceed the memory of a picture and its upload time.
constexpr std::uint64_t MostTiles = std::uint64_t(1) << 20;
constexpr std::uint64_t MostCandidates = std::uint64_t(1) << 22;

constexpr int MostShift = 16; // one tile for the largest picture

vtkIdType numberOf(std::size_t count) { return static_cast<vtkIdType>(count); }

// Pixels of a tile, from its lower left; first and last.
struct PixelRange
{
  int Left;
  int Right;
  int Bottom;
  int Top;
};

// The part of a footprint in a tile.
EntryCandidate candidateOf(
  std::uint32_t face, std::uint32_t nearest, const PixelRange& inTile, int tileShift)
{
  const int shift = std::max(tileShift - MostEntryTileShift, 0);
  const auto left = static_cast<std::uint32_t>(inTile.Left >> shift);
  const auto right = static_cast<std::uint32_t>(inTile.Right >> shift);
  const auto bottom = static_cast<std::uint32_t>(inTile.Bottom >> shift);
  const auto top = static_cast<std::uint32_t>(inTile.Top >> shift);
  return { face, nearest << 16 | top << 12 | bottom << 8 | right << 4 | left };
}

class ListMaker
{
public:
  ListMaker(const TetMesh& mesh, const std::vector<std::array<Id, 4>>& faces, const View& view,
    int width, int height, std::uint64_t mostTexels)
    : Projection(mesh.Frame, view, width, height)
    , Vertices(mesh.Vertices)
    , Faces(faces)
    , Width(width)
    , Height(height)
    , MostTexels(mostTexels)
  {
  }

  EntryLists make()
  {
    this->Lists.DepthPlane = this->Projection.depthPlane();
    this->findFootprints();
    this->chooseTiles();
    this->countCandidates();
    this->fillCandidates();
    this->sortTiles();
    return std::move(this->Lists);
  }

private:
  int tilesAlong(int pixels) const
  {
    const int edge = 1 << this->Lists.TileShift;
    return (pixels + edge - 1) / edge;
  }

  void findFootprints()
  {
    this->Footprints.resize(this->Faces.size());
    parallelFor(0, numberOf(this->Footprints.size()),
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType face = begin; face < end; ++face)
        {
          this->Footprints[face] = this->Projection.footprintOf(this->cornersOf(face));
        }
      });
  }

  // Tiles are about as large as the footprint of a face: lists are short, and a face is in few of
  // them.
  void chooseTiles()
  {
    double pixels = 0;
    double faces = 0;
    for (const Footprint& footprint : this->Footprints)
    {
      pixels += footprint.pixels();
      faces += footprint.isEmpty() ? 0 : 1;
    }
    int& shift = this->Lists.TileShift;
    while (shift < MostEntryTileShift && std::ldexp(2.0, 2 * shift) * faces < pixels)
    {
      ++shift;
    }
    while (shift < MostEntryTileShift && !this->fits(MostTiles, MostCandidates))
    {
      ++shift;
    }
    while (shift < MostShift && !this->fits(this->MostTexels - 1, this->MostTexels))
    {
      ++shift;
    }
    this->Lists.TilesPerRow = this->tilesAlong(this->Width);
  }

  bool fits(std::uint64_t mostTiles, std::uint64_t mostCandidates) const
  {
    return this->numberOfTiles() <= mostTiles && this->mostCandidates() <= mostCandidates;
  }

  std::uint64_t numberOfTiles() const
  {
    return std::uint64_t(this->tilesAlong(this->Width)) * this->tilesAlong(this->Height);
  }

  // Maximum number of candidates with the current tiles.
  std::uint64_t mostCandidates() const
  {
    const int shift = this->Lists.TileShift;
    std::uint64_t sum = 0;
    for (const Footprint& f : this->Footprints)
    {
      sum += f.isEmpty() ? 0
                         : std::uint64_t((f.Right >> shift) - (f.Left >> shift) + 1) *
                             ((f.Top >> shift) - (f.Bottom >> shift) + 1);
    }
    return sum;
  }

  // Call visit(tile, pixels) for each tile that has pixels of a face; the pixels are counted from
  // the tile's lower left.
  template <typename Visit>
  void visitTiles(vtkIdType face, const Visit& visit) const
  {
    const Footprint& footprint = this->Footprints[face];
    if (footprint.isEmpty())
    {
      return;
    }
    const int shift = this->Lists.TileShift;
    const int last = (1 << shift) - 1;
    const bool isSmall = (footprint.Left >> shift) == (footprint.Right >> shift) ||
                         (footprint.Bottom >> shift) == (footprint.Top >> shift);
    const ProjectedFace projected =
      isSmall ? ProjectedFace() : this->Projection.project(this->cornersOf(face));
    for (int row = footprint.Bottom >> shift; row <= footprint.Top >> shift; ++row)
    {
      const int bottom = std::max<int>(footprint.Bottom, row << shift);
      const int top = std::min<int>(footprint.Top, (row << shift) + last);
      int left = footprint.Left;
      int right = footprint.Right;
      if (!isSmall)
      {
        projected.narrow(bottom, top, left, right);
      }
      for (int column = left >> shift; column <= right >> shift && left <= right; ++column)
      {
        const int x = column << shift;
        const int y = row << shift;
        visit(static_cast<std::size_t>(row) * this->Lists.TilesPerRow + column,
          PixelRange{ std::max(left - x, 0), std::min(right - x, last), bottom - y, top - y });
      }
    }
  }

  template <typename Visit>
  void visitAllTiles(const Visit& visit) const
  {
    parallelFor(0, numberOf(this->Footprints.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType face = begin; face < end; ++face)
        {
          this->visitTiles(
            face, [&](std::size_t tile, const PixelRange& pixels) { visit(face, tile, pixels); });
        }
      });
  }

  void countCandidates()
  {
    const auto tiles = static_cast<std::size_t>(this->numberOfTiles());
    this->Next = std::vector<std::atomic<std::uint32_t>>(tiles);
    this->visitAllTiles([this](vtkIdType, std::size_t tile, const PixelRange&)
      { this->Next[tile].fetch_add(1, std::memory_order_relaxed); });
    this->Lists.First.resize(tiles + 1);
    std::uint32_t sum = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile)
    {
      this->Lists.First[tile] = sum;
      sum += this->Next[tile].exchange(sum, std::memory_order_relaxed);
    }
    this->Lists.First[tiles] = sum;
  }

  void fillCandidates()
  {
    this->Lists.Candidates.resize(this->Lists.First.back());
    this->visitAllTiles(
      [this](vtkIdType face, std::size_t tile, const PixelRange& pixels)
      {
        const std::uint32_t at = this->Next[tile].fetch_add(1, std::memory_order_relaxed);
        this->Lists.Candidates[at] = candidateOf(static_cast<std::uint32_t>(face),
          this->Footprints[face].Nearest, pixels, this->Lists.TileShift);
      });
  }

  // By depth; those of equal depth by index, so that the order does not depend on the threads.
  void sortTiles()
  {
    const auto isNearer = [](const EntryCandidate& a, const EntryCandidate& b)
    {
      const std::uint32_t depthA = a.Where >> 16;
      const std::uint32_t depthB = b.Where >> 16;
      return depthA != depthB ? depthA < depthB : a.Face < b.Face;
    };
    parallelFor(0, numberOf(this->Lists.First.size()) - 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType tile = begin; tile < end; ++tile)
        {
          std::sort(this->Lists.Candidates.begin() + this->Lists.First[tile],
            this->Lists.Candidates.begin() + this->Lists.First[tile + 1], isNearer);
        }
      });
  }

  FaceCorners cornersOf(vtkIdType face) const
  {
    const std::array<Id, 4>& ids = this->Faces[face];
    return { { &this->Vertices[ids[0]], &this->Vertices[ids[1]], &this->Vertices[ids[2]] } };
  }

  FaceProjection Projection;
  const std::vector<Vertex>& Vertices;
  const std::vector<std::array<Id, 4>>& Faces;
  int Width;
  int Height;
  std::uint64_t MostTexels;
  EntryLists Lists;
  std::vector<Footprint> Footprints;
  std::vector<std::atomic<std::uint32_t>> Next; // the index of the next candidate of a tile
};

} // namespace

EntryLists makeEntryLists(const TetMesh& mesh, const std::vector<std::array<Id, 4>>& faces,
  const View& view, int width, int height)
{
  constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();
  return makeEntryListsWithin(any, mesh, faces, view, width, height);
}

EntryLists makeEntryListsWithin(std::uint64_t mostTexels, const TetMesh& mesh,
  const std::vector<std::array<Id, 4>>& faces, const View& view, int width, int height)
{
  return ListMaker(mesh, faces, view, width, height, mostTexels).make();
}

} // namespace tetmarch
