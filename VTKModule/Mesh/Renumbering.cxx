// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Renumbering.h"

#include "Parallel/HugePages.h"
#include "Parallel/ParallelFor.h"

#include "vtkPoints.h"

#include <algorithm>
#include <numeric>

namespace tetmarch
{
namespace
{

// Spread the 21 bits of one coordinate of a Morton code: two free bits follow each.
std::uint64_t spread(std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

std::uint64_t mortonCode(const Vertex& v)
{
  const auto cell = [](float x)
  {
    return static_cast<std::uint64_t>(
      std::min(std::max((x + 1.0f) * 0.5f, 0.0f), 1.0f) * 2097151.0f);
  };
  return spread(cell(v.X)) | spread(cell(v.Y)) << 1 | spread(cell(v.Z)) << 2;
}

// The order of the keys, by a stable radix sort with 11 bits per pass.
std::vector<Id> sortedOrder(const std::vector<std::uint64_t>& keys)
{
  auto order = filledWith<Id>(keys.size());
  auto next = filledWith<Id>(keys.size());
  std::iota(order.begin(), order.end(), Id(0));
  for (int shift = 0; shift < 63; shift += 11)
  {
    std::vector<std::size_t> starts(2049, 0);
    for (std::uint64_t key : keys)
    {
      ++starts[(key >> shift & 2047) + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    for (Id i : order)
    {
      next[starts[keys[i] >> shift & 2047]++] = i;
    }
    order.swap(next);
  }
  return order;
}

// Points that tetrahedra use, ascending, and the position of each in that list.
struct UsedPoints
{
  std::vector<Id> Points;
  std::vector<Id> Index;
};

UsedPoints findUsedPoints(const Decomposition& tets, std::size_t count)
{
  UsedPoints used;
  used.Index = filledWith<Id>(count);
  for (const auto& tet : tets.Tets)
  {
    for (Id id : tet)
    {
      used.Index[id] = 1;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (used.Index[i])
    {
      used.Index[i] = static_cast<Id>(used.Points.size());
      used.Points.push_back(static_cast<Id>(i));
    }
  }
  return used;
}

// Tetrahedra with ascending vertices, ordered by the first; those with a repeated vertex are left
// out.
bool orderTets(const Decomposition& from, const UsedPoints& used, const std::vector<Id>& rank,
  const Progress& progress, TetMesh& mesh)
{
  auto tets = filledWith<std::array<Id, 4>>(from.Tets.size());
  const bool finished = parallelFor(static_cast<vtkIdType>(tets.size()), progress,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        auto& tet = tets[t];
        for (int i = 0; i < 4; ++i)
        {
          tet[i] = rank[used.Index[from.Tets[t][i]]];
        }
        std::sort(tet.begin(), tet.end());
      }
    });
  if (!finished)
  {
    return false;
  }
  const auto isDegenerate = [](const std::array<Id, 4>& t)
  { return t[0] == t[1] || t[1] == t[2] || t[2] == t[3]; };
  auto starts = filledWith<Id>(mesh.Vertices.size() + 1);
  for (const auto& tet : tets)
  {
    if (isDegenerate(tet))
    {
      ++mesh.Report.DegenerateTetrahedra;
    }
    else
    {
      ++starts[tet[0] + 1];
    }
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::array<Id, 4>>& ordered = mesh.Tets.stored();
  std::vector<Id>& cells = mesh.TetCells.stored();
  ordered = filledWith<std::array<Id, 4>>(starts.back());
  cells = filledWith<Id>(starts.back());
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    if (!isDegenerate(tets[t]))
    {
      const Id at = starts[tets[t][0]]++;
      ordered[at] = tets[t];
      cells[at] = from.Cells[t];
    }
  }
  return true;
}

} // namespace

std::string renumber(vtkPoints* points, Decomposition&& tets, const Progress& progress,
  TetMesh& mesh, bool& stopped, const PieceOptions& piece)
{
  const std::size_t pointCount = points ? points->GetNumberOfPoints() : 0;
  mesh.NumberOfPoints = static_cast<vtkIdType>(pointCount);
  mesh.CenterCells = tets.CenterCells;
  mesh.FirstPoints = std::move(tets.FirstPoints);
  mesh.PointsAreSeparate = piece.SeparatePoints;
  mesh.Report = tets.Report;
  mesh.HasCutCells = tets.HasCutCells;

  const UsedPoints used = findUsedPoints(tets, pointCount + tets.CenterCells.size());
  const std::size_t vertexCount = used.Points.size();
  auto positions = filledWith<Vector3>(vertexCount);
  parallelFor(0, static_cast<vtkIdType>(vertexCount),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const Id p = used.Points[i];
        if (p < pointCount)
        {
          points->GetPoint(p, positions[i].data());
          for (double& x : positions[i])
          {
            x = piece.InFloat ? roundedToFloat(x) : x;
          }
        }
        else
        {
          positions[i] = tets.CenterPositions[p - pointCount];
        }
      }
    });
  mesh.Frame = piece.Frame;
  std::string wrong = piece.IsPiece ? std::string() : findFrame(positions, mesh.Frame);
  if (!wrong.empty())
  {
    return wrong;
  }

  auto vertices = filledWith<Vertex>(vertexCount);
  auto codes = filledWith<std::uint64_t>(vertexCount);
  parallelFor(0, static_cast<vtkIdType>(vertexCount),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        vertices[i] = vertexAt(positions[i], mesh.Frame);
        codes[i] = mortonCode(vertices[i]);
      }
    });
  const std::vector<Id> order = sortedOrder(codes);
  auto rank = filledWith<Id>(vertexCount);
  mesh.Vertices = filledWith<Vertex>(vertexCount);
  std::vector<Id>& vertexPoints = mesh.VertexPoints.stored();
  vertexPoints = filledWith<Id>(vertexCount);
  for (std::size_t i = 0; i < vertexCount; ++i)
  {
    rank[order[i]] = static_cast<Id>(i);
    mesh.Vertices[i] = vertices[order[i]];
    vertexPoints[i] = used.Points[order[i]];
  }
  stopped = !orderTets(tets, used, rank, progress, mesh);
  return {};
}

} // namespace tetmarch
