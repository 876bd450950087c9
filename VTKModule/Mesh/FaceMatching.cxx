// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceMatching.h"

#include "Mesh/ConsistentOrientation.h"
#include "Mesh/Orientation.h"
#include "Parallel/HugePages.h"

#include <algorithm>
#include <mutex>
#include <numeric>

namespace tetmarch
{
namespace
{

// A half-face, identified by the two larger vertices of its face.
struct Owner
{
  std::uint64_t Key; // the middle vertex, then the largest
  Id HalfFace;
  bool operator<(const Owner& other) const
  {
    return std::make_pair(this->Key, this->HalfFace) < std::make_pair(other.Key, other.HalfFace);
  }
};

std::uint64_t makeKey(Id middle, Id largest) { return std::uint64_t(middle) << 32 | largest; }

// For each vertex the index of its first tetrahedron if tetrahedra are sorted by their vertex of
// that rank.
std::vector<Id> startsByRank(const TetMesh& mesh, int rank)
{
  auto starts = filledWith<Id>(mesh.Vertices.size() + 1);
  for (const auto& tet : mesh.Tets)
  {
    ++starts[tet[rank] + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

// Tetrahedra by their second vertex, which is the smallest of their face 0.
struct SecondVertexLists
{
  std::vector<Id> Starts;
  std::vector<Id> Tets;
};

SecondVertexLists listBySecond(const TetMesh& mesh)
{
  SecondVertexLists lists;
  lists.Starts = startsByRank(mesh, 1);
  lists.Tets = filledWith<Id>(mesh.Tets.size());
  std::vector<Id> next(lists.Starts.begin(), lists.Starts.end() - 1);
  for (Id t = 0; t < mesh.numberOfTets(); ++t)
  {
    lists.Tets[next[mesh.Tets[t][1]]++] = t;
  }
  return lists;
}

Id apexOf(const TetMesh& mesh, Id halfFace) { return mesh.Tets[halfFace / 4][halfFace % 4]; }

class Matcher
{
public:
  Matcher(TetMesh& mesh, FaceMatching& found)
    : Mesh(mesh)
    , Found(found)
    , Starts(startsByRank(mesh, 0)) // sorted already
    , Second(listBySecond(mesh))
  {
  }

  bool match(const Progress& progress)
  {
    this->Mesh.Links.stored() = filledWith(4 * this->Mesh.Tets.size(), Unlinked);
    return parallelFor(static_cast<vtkIdType>(this->Mesh.Vertices.size()), progress,
      [this](vtkIdType first, vtkIdType last) { this->matchRange(first, last); });
  }

private:
  void matchRange(vtkIdType first, vtkIdType last)
  {
    FaceMatching found;
    std::vector<Owner> owners;
    for (vtkIdType v = first; v < last; ++v)
    {
      this->gather(static_cast<Id>(v), owners);
      std::sort(owners.begin(), owners.end());
      for (std::size_t i = 0; i < owners.size();)
      {
        std::size_t end = i + 1;
        while (end < owners.size() && owners[end].Key == owners[i].Key)
        {
          ++end;
        }
        this->matchFace(static_cast<Id>(v), &owners[i], end - i, found);
        i = end;
      }
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Found.Duplicates.insert(
      this->Found.Duplicates.end(), found.Duplicates.begin(), found.Duplicates.end());
    this->Found.Cancelled.insert(
      this->Found.Cancelled.end(), found.Cancelled.begin(), found.Cancelled.end());
    this->Found.Boundary.insert(
      this->Found.Boundary.end(), found.Boundary.begin(), found.Boundary.end());
    this->Found.ManyOwners = this->Found.ManyOwners || found.ManyOwners;
    this->Found.NonManifoldFaces += found.NonManifoldFaces;
    this->Found.Agree = this->Found.Agree && found.Agree;
  }

  // The half-faces whose smallest vertex is v.
  void gather(Id v, std::vector<Owner>& owners) const
  {
    owners.clear();
    for (Id t = this->Starts[v]; t < this->Starts[v + 1]; ++t)
    {
      const auto& tet = this->Mesh.Tets[t];
      owners.push_back({ makeKey(tet[2], tet[3]), 4 * t + 1 });
      owners.push_back({ makeKey(tet[1], tet[3]), 4 * t + 2 });
      owners.push_back({ makeKey(tet[1], tet[2]), 4 * t + 3 });
    }
    for (Id i = this->Second.Starts[v]; i < this->Second.Starts[v + 1]; ++i)
    {
      const auto& tet = this->Mesh.Tets[this->Second.Tets[i]];
      owners.push_back({ makeKey(tet[2], tet[3]), 4 * this->Second.Tets[i] });
    }
  }

  void matchFace(Id smallest, const Owner* owners, std::size_t count, FaceMatching& found)
  {
    if (count > 1 && this->findDuplicates(owners, count, found))
    {
      return; // matching starts again without them
    }
    if (count == 2)
    {
      this->join(owners[0].HalfFace, owners[1].HalfFace);
      found.Agree =
        found.Agree && this->sideOf(owners[0].HalfFace) * this->sideOf(owners[1].HalfFace) < 0;
    }
    else if (count == 1)
    {
      found.Boundary.emplace_back(smallest, owners[0].HalfFace);
    }
    else
    {
      this->matchManyOwners(smallest, owners, count, found);
    }
  }

  // Owners on opposite sides are linked in the order of their numbers; flat ones complete the side
  // with fewer owners. For the remaining owners it is a boundary face.
  void matchManyOwners(Id smallest, const Owner* owners, std::size_t count, FaceMatching& found)
  {
    found.ManyOwners = true;
    std::vector<Id> above, below, flat;
    for (std::size_t i = 0; i < count; ++i)
    {
      const int side = this->sideOf(owners[i].HalfFace);
      (side > 0 ? above : (side < 0 ? below : flat)).push_back(owners[i].HalfFace);
    }
    for (Id halfFace : flat)
    {
      (above.size() < below.size() ? above : below).push_back(halfFace);
    }
    const std::size_t pairs = std::min(above.size(), below.size());
    for (std::size_t i = 0; i < pairs; ++i)
    {
      this->join(above[i], below[i]);
    }
    const std::vector<Id>& rest = above.size() > pairs ? above : below;
    std::size_t next = pairs;
    for (; this->Mesh.HasCutCells && next + 1 < rest.size(); next += 2)
    {
      this->join(rest[next], rest[next + 1]);
      found.Agree = false;
    }
    for (; next < rest.size(); ++next)
    {
      found.Boundary.emplace_back(smallest, rest[next]);
      found.NonManifoldFaces += next + 1 == rest.size() ? 1 : 0;
    }
  }

  // Owners of one face with the same apex are the same tetrahedron: all except the first are
  // dropped. But decomposition can produce a tetrahedron twice that should not exist: once outside
  // of a cell that lacks it, and once inside of a cell that contains it in excess. This happens if
  // two faces of a cell overlap because a point lies on the diagonal of both, or if two cells share
  // two adjacent faces and it lies between them. Then both are dropped, and their neighbours are
  // linked. The second case is recognised by two further owners.
  bool findDuplicates(const Owner* owners, std::size_t count, FaceMatching& found) const
  {
    if (count == 2 &&
        apexOf(this->Mesh, owners[0].HalfFace) != apexOf(this->Mesh, owners[1].HalfFace))
    {
      return false; // nearly every face: no list is needed
    }
    std::vector<std::pair<Id, Id>> tets; // apex, tetrahedron
    for (std::size_t i = 0; i < count; ++i)
    {
      tets.emplace_back(apexOf(this->Mesh, owners[i].HalfFace), owners[i].HalfFace / 4);
    }
    std::sort(tets.begin(), tets.end());
    std::size_t different = 1;
    for (std::size_t i = 1; i < count; ++i)
    {
      different += tets[i].first != tets[i - 1].first ? 1 : 0;
    }
    for (std::size_t i = 1; i < count && different < count; ++i)
    {
      if (tets[i].first != tets[i - 1].first)
      {
        continue;
      }
      const bool sameCell =
        this->Mesh.TetCells[tets[i].second] == this->Mesh.TetCells[tets[i - 1].second];
      if (sameCell || (this->Mesh.HasCutCells && different > 2))
      {
        found.Cancelled.insert(found.Cancelled.end(), { tets[i - 1].second, tets[i].second });
      }
      found.Duplicates.push_back(tets[i].second);
    }
    return different < count;
  }

  // The same as inwardSide(), from a table.
  int sideOf(Id halfFace) const { return this->Found.Signs[halfFace / 4] * parity(halfFace % 4); }

  void join(Id a, Id b)
  {
    this->Mesh.Links.stored()[a] = b;
    this->Mesh.Links.stored()[b] = a;
  }

  TetMesh& Mesh;
  FaceMatching& Found;
  std::vector<Id> Starts;
  SecondVertexLists Second;
  std::mutex Mutex;
};

} // namespace

bool matchFaces(const Progress& progress, TetMesh& mesh, FaceMatching& found)
{
  found = {};
  found.Signs = volumeSigns(mesh);
  if (!Matcher(mesh, found).match(progress))
  {
    return false;
  }
  found.Agree =
    found.Agree && std::find(found.Signs.begin(), found.Signs.end(), 0) == found.Signs.end();
  return true;
}

} // namespace tetmarch
