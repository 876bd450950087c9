// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/EntryListMaker.h"

#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <limits>

namespace tetmarch
{
namespace
{

// More tiles or candidates would exceed the memory of a picture and its upload time.
constexpr std::uint64_t MostTiles = std::uint64_t(1) << 20;
constexpr std::uint64_t MostCandidates = std::uint64_t(1) << 22;

constexpr int MostShift = 16; // one tile for the largest picture

constexpr std::size_t FacesOfChunk = 4096;
constexpr std::size_t FacesOfBatch = 64;

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

// By depth; those of equal depth by index, so that the order does not depend on the threads.
std::uint64_t orderOf(const EntryCandidate& candidate)
{
  return std::uint64_t(candidate.Where >> 16) << 32 | candidate.Face;
}

// Call work(i) for i = 0 .. count - 1, in parallel.
template <typename Work>
void forEach(std::size_t count, const Work& work)
{
  parallelFor(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        work(static_cast<std::size_t>(i));
      }
    });
}

// The sum of valueOf(i), a whole number, for i = 0 .. count - 1.
template <typename Value>
std::uint64_t sumOf(std::size_t count, const Value& valueOf)
{
  std::atomic<std::uint64_t> sum(0);
  parallelFor(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::uint64_t part = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        part += valueOf(static_cast<std::size_t>(i));
      }
      sum += part;
    });
  return sum;
}

} // namespace

const EntryLists& EntryListMaker::make(std::uint64_t mostTexels, const TetMesh& mesh,
  const std::vector<std::array<Id, 4>>& faces, const View& view, int width, int height,
  const EyeStart& start)
{
  this->Projection.emplace(mesh.Frame, view, width, height);
  this->Vertices = mesh.Vertices.data();
  this->Faces = &faces;
  this->Start = &start;
  this->Width = width;
  this->Height = height;
  this->Lists.DepthPlane = this->Projection->depthPlane();
  this->findFootprints();
  this->chooseTiles(mostTexels);
  this->findCandidates();
  this->sortCandidates();
  return this->Lists;
}

int EntryListMaker::tilesAlong(int pixels) const
{
  const int edge = 1 << this->Lists.TileShift;
  return (pixels + edge - 1) / edge;
}

void EntryListMaker::findFootprints()
{
  const std::size_t count = this->Faces->size();
  this->Footprints.resize(count + this->Start->Inside.size());
  forEach((count + FacesOfBatch - 1) / FacesOfBatch,
    [this](std::size_t batch) { this->findFootprintsOf(batch); });
  for (const std::size_t face : this->Start->OfPart)
  {
    this->coverPicture(face);
  }
  for (std::size_t face = count; face < this->Footprints.size(); ++face)
  {
    this->coverPicture(face);
  }
}

void EntryListMaker::coverPicture(std::size_t face)
{
  this->Footprints[face] = this->Projection->wholePicture(this->cornersOf(face));
}

// All vertices are fetched first: the processor waits for many at once.
void EntryListMaker::findFootprintsOf(std::size_t batch)
{
  std::array<std::array<Vertex, 3>, FacesOfBatch> corners;
  const std::size_t first = batch * FacesOfBatch;
  const std::size_t count = std::min(FacesOfBatch, this->Faces->size() - first);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::array<Id, 4>& ids = (*this->Faces)[first + i];
    corners[i] = { { this->Vertices[ids[0]], this->Vertices[ids[1]], this->Vertices[ids[2]] } };
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& of = corners[i];
    this->Footprints[first + i] = this->Projection->footprintOf({ { of.data(), &of[1], &of[2] } });
  }
}

// Tiles are about as large as the footprint of a face: lists are short, and a face is in few of
// them. Faces around the eye, which cover the picture, count as the largest tile.
void EntryListMaker::chooseTiles(std::uint64_t mostTexels)
{
  const std::size_t count = this->Footprints.size();
  constexpr std::uint64_t most = std::uint64_t(2) << (2 * MostEntryTileShift);
  const auto pixels =
    sumOf(count, [&](std::size_t face) { return std::min(this->Footprints[face].pixels(), most); });
  const auto faces =
    sumOf(count, [this](std::size_t face) { return this->Footprints[face].isEmpty() ? 0 : 1; });
  int& shift = this->Lists.TileShift;
  shift = 0;
  while (shift < MostEntryTileShift && (faces << (2 * shift + 1)) < pixels)
  {
    ++shift;
  }
  while (shift < MostEntryTileShift && !this->fits(MostTiles, MostCandidates))
  {
    ++shift;
  }
  while (shift < MostShift && !this->fits(mostTexels - 1, mostTexels))
  {
    ++shift;
  }
  this->Lists.TilesPerRow = this->tilesAlong(this->Width);
}

bool EntryListMaker::fits(std::uint64_t mostTiles, std::uint64_t mostCandidates) const
{
  return this->numberOfTiles() <= mostTiles && this->mostCandidates() <= mostCandidates;
}

std::uint64_t EntryListMaker::numberOfTiles() const
{
  return std::uint64_t(this->tilesAlong(this->Width)) * this->tilesAlong(this->Height);
}

// Maximum number of candidates with the current tiles.
std::uint64_t EntryListMaker::mostCandidates() const
{
  const int shift = this->Lists.TileShift;
  return sumOf(this->Footprints.size(),
    [&](std::size_t face)
    {
      const Footprint& f = this->Footprints[face];
      return f.isEmpty() ? std::uint64_t(0)
                         : std::uint64_t((f.Right >> shift) - (f.Left >> shift) + 1) *
                             ((f.Top >> shift) - (f.Bottom >> shift) + 1);
    });
}

// Call visit(tile, pixels) for each tile that has pixels of a face; the pixels are counted from
// the tile's lower left.
template <typename Visit>
void EntryListMaker::visitTiles(std::size_t face, const Visit& visit) const
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
    isSmall ? ProjectedFace() : this->Projection->project(this->cornersOf(face));
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
      visit(static_cast<std::uint32_t>(row * this->Lists.TilesPerRow + column),
        PixelRange{ std::max(left - x, 0), std::min(right - x, last), bottom - y, top - y });
    }
  }
}

// First by faces, then in the lists of their tiles.
void EntryListMaker::findCandidates()
{
  const auto tiles = static_cast<std::size_t>(this->numberOfTiles());
  if (this->Counts.size() != tiles)
  {
    this->Counts = std::vector<std::atomic<std::uint32_t>>(tiles);
  }
  forEach(tiles, [this](std::size_t tile) { this->Counts[tile] = 0; });
  this->Found.resize((this->Footprints.size() + FacesOfChunk - 1) / FacesOfChunk);
  forEach(this->Found.size(), [this](std::size_t chunk) { this->findCandidatesOf(chunk); });
  this->Lists.First.resize(tiles + 1);
  std::uint32_t sum = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    this->Lists.First[tile] = sum;
    sum += this->Counts[tile].load(std::memory_order_relaxed);
  }
  this->Lists.First[tiles] = sum;
  this->Lists.Candidates.resize(sum);
  forEach(this->Found.size(),
    [this](std::size_t chunk)
    {
      for (const FoundCandidate& found : this->Found[chunk])
      {
        this->Lists.Candidates[this->Lists.First[found.Tile] + found.Place] = found.Candidate;
      }
    });
}

void EntryListMaker::findCandidatesOf(std::size_t chunk)
{
  std::vector<FoundCandidate>& found = this->Found[chunk];
  found.clear();
  const std::size_t end = std::min((chunk + 1) * FacesOfChunk, this->Footprints.size());
  for (std::size_t face = chunk * FacesOfChunk; face < end; ++face)
  {
    this->visitTiles(face,
      [&](std::uint32_t tile, const PixelRange& pixels)
      {
        found.push_back({ tile, this->Counts[tile].fetch_add(1, std::memory_order_relaxed),
          candidateOf(static_cast<std::uint32_t>(face), this->Footprints[face].Nearest, pixels,
            this->Lists.TileShift) });
      });
  }
}

void EntryListMaker::sortCandidates()
{
  forEach(this->Lists.First.size() - 1,
    [this](std::size_t tile)
    {
      std::sort(this->Lists.Candidates.begin() + this->Lists.First[tile],
        this->Lists.Candidates.begin() + this->Lists.First[tile + 1],
        [](const EntryCandidate& a, const EntryCandidate& b) { return orderOf(a) < orderOf(b); });
    });
}

FaceCorners EntryListMaker::cornersOf(std::size_t face) const
{
  const std::size_t count = this->Faces->size();
  const std::array<Id, 4>& ids =
    face < count ? (*this->Faces)[face] : this->Start->Inside[face - count];
  return { { this->Vertices + ids[0], this->Vertices + ids[1], this->Vertices + ids[2] } };
}

EntryLists makeEntryLists(const TetMesh& mesh, const std::vector<std::array<Id, 4>>& faces,
  const View& view, int width, int height)
{
  constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();
  return EntryListMaker().make(any, mesh, faces, view, width, height);
}

} // namespace tetmarch
