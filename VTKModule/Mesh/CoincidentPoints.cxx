// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CoincidentPoints.h"

#include "Input/CellKind.h"
#include "Input/CellTypes.h"
#include "Input/PointCheck.h"
#include "Mesh/PieceOptions.h"
#include "Parallel/HugePages.h"
#include "Parallel/ParallelFor.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <atomic>
#include <cstring>
#include <numeric>

namespace tetmarch
{
namespace
{

// A point and a hash of its coordinates.
struct Hashed
{
  std::uint32_t Hash;
  Id Point;
};

// Points are divided by their hash into buckets, and searched in a table a bucket, which the
// processor's cache holds.
class PlaceTable
{
public:
  PlaceTable(vtkPoints* points, bool inFloat)
    : Points(points)
    , InFloat(inFloat)
    , Count(static_cast<std::size_t>(points->GetNumberOfPoints()))
  {
    while (Bits < 16 && (Count >> Bits) > PointsOfBucket)
    {
      ++this->Bits;
    }
  }

  // Empty if no two points coincide.
  std::vector<Id> findFirsts()
  {
    this->fillBuckets();
    auto firsts = filledWith<Id>(this->Count);
    std::iota(firsts.begin(), firsts.end(), Id(0));
    std::atomic<bool> any(false);
    parallelFor(0, static_cast<vtkIdType>(this->Starts.size()) - 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<Hashed> table;
        for (vtkIdType bucket = begin; bucket < end; ++bucket)
        {
          if (this->searchBucket(static_cast<std::size_t>(bucket), table, firsts))
          {
            any = true;
          }
        }
      });
    return any ? firsts : std::vector<Id>();
  }

private:
  static constexpr std::size_t PointsOfBucket = 2048;

  Vector3 placeOf(Id point) const
  {
    Vector3 place;
    this->Points->GetPoint(point, place.data());
    for (double& x : place)
    {
      x = (this->InFloat ? roundedToFloat(x) : x) + 0.0; // -0 is 0
    }
    return place;
  }

  static std::uint32_t hashOf(const Vector3& place)
  {
    std::uint64_t hash = 0;
    for (const double x : place)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof(x));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::uint32_t>(hash);
  }

  std::size_t bucketOf(std::uint32_t hash) const
  {
    return this->Bits > 0 ? hash >> (32 - this->Bits) : 0;
  }

  // Ascending points in each bucket.
  void fillBuckets()
  {
    auto hashes = filledWith<std::uint32_t>(this->Count);
    parallelFor(0, static_cast<vtkIdType>(this->Count),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          hashes[i] = hashOf(this->placeOf(static_cast<Id>(i)));
        }
      });
    this->Starts.assign((std::size_t(1) << this->Bits) + 1, 0);
    for (const std::uint32_t hash : hashes)
    {
      ++this->Starts[this->bucketOf(hash) + 1];
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Buckets = filledWith<Hashed>(this->Count);
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Buckets[next[this->bucketOf(hashes[i])]++] = { hashes[i], static_cast<Id>(i) };
    }
  }

  bool searchBucket(std::size_t bucket, std::vector<Hashed>& table, std::vector<Id>& firsts) const
  {
    const std::size_t begin = this->Starts[bucket];
    const std::size_t end = this->Starts[bucket + 1];
    std::size_t size = 16;
    while (size < 2 * (end - begin))
    {
      size *= 2;
    }
    table.assign(size, { 0, NoPoint });
    bool any = false;
    for (std::size_t i = begin; i < end; ++i)
    {
      const Hashed& point = this->Buckets[i];
      std::size_t slot = point.Hash & (size - 1);
      while (table[slot].Point != NoPoint && !this->coincide(table[slot], point))
      {
        slot = (slot + 1) & (size - 1);
      }
      if (table[slot].Point == NoPoint)
      {
        table[slot] = point;
      }
      else
      {
        firsts[point.Point] = table[slot].Point;
        any = true;
      }
    }
    return any;
  }

  // Points that are not sound belong to no cell. Taken for equal, they can't fill a table.
  bool coincide(const Hashed& a, const Hashed& b) const
  {
    if (a.Hash != b.Hash)
    {
      return false;
    }
    const Vector3 p = this->placeOf(a.Point);
    const Vector3 q = this->placeOf(b.Point);
    return std::memcmp(p.data(), q.data(), sizeof(p)) == 0;
  }

  vtkPoints* Points;
  bool InFloat;
  std::size_t Count;
  int Bits = 0; // the number of buckets is a power of two
  std::vector<std::size_t> Starts;
  std::vector<Hashed> Buckets;
};

// For each point whether a 3D cell has it.
std::vector<std::uint8_t> findPointsOfSolids(vtkUnstructuredGrid* grid)
{
  std::vector<std::uint8_t> used(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  const CellTypes types(grid);
  vtkCellArray* cells = grid->GetCells();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const CellCut cut = cellKinds()[types[cell]].Cut;
    if (cut == CellCut::Tetrahedron || cut == CellCut::Pieces || cut == CellCut::Polyhedron ||
        cut == CellCut::ByVTK)
    {
      cells->GetCellAtId(cell, points);
      for (const vtkIdType point : *points)
      {
        used[static_cast<std::size_t>(point)] = 1;
      }
    }
  }
  return used;
}

// The first of points of cells in place of the first of all points.
bool keepUsed(const std::vector<std::uint8_t>& used, std::vector<Id>& firsts)
{
  std::vector<Id> best(firsts.size(), NoPoint);
  bool any = false;
  for (std::size_t i = 0; i < firsts.size(); ++i)
  {
    if (!used[i])
    {
      firsts[i] = NoPoint;
      continue;
    }
    Id& first = best[firsts[i]];
    any = any || first != NoPoint;
    first = first == NoPoint ? static_cast<Id>(i) : first;
    firsts[i] = first;
  }
  return any;
}

} // namespace

std::vector<Id> findCoincidentPoints(vtkUnstructuredGrid* grid, bool inFloat)
{
  if (!grid->GetPoints() || grid->GetNumberOfPoints() == 0)
  {
    return {};
  }
  std::vector<Id> firsts = PlaceTable(grid->GetPoints(), inFloat).findFirsts();
  if (!firsts.empty() && !keepUsed(findPointsOfSolids(grid), firsts))
  {
    firsts.clear();
  }
  return firsts;
}

} // namespace tetmarch
