// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurvilinearCells.h"

namespace tetmarch
{
namespace
{

// Of a path, whose vertices need not ascend: how many are before one of them.
int rankOf(const std::array<Id, 4>& path, int place)
{
  return static_cast<int>(
    std::count_if(path.begin(), path.end(), [&](Id vertex) { return vertex < path[place]; }));
}

} // namespace

CurvilinearCells::CurvilinearCells(const std::array<Id, 3>& cells, const JoinedSides& joins)
  : Cells(cells)
  , Joins(joins)
  , IsJoined(joins.any())
{
  for (int a = 0; a < 3; ++a)
  {
    const Id side = joins.Rings[a] ? 0 : 2 * this->sideCells(a);
    this->FirstFaces[2 * a + 1] = this->FirstFaces[2 * a] + side;
    this->FirstFaces[2 * a + 2] = this->FirstFaces[2 * a + 1] + side;
  }
  this->BoundaryOrder.resize(this->FirstFaces[6]);
  Id faces = 0;
  for (Id number = 0; number < this->FirstFaces[6]; ++number)
  {
    const HalfFace at = this->onSide(number);
    const std::array<Id, 4> path = this->path(at.Of);
    const auto begin = path.begin() + (at.Opposite == 0 ? 1 : 0);
    const bool isFlat = std::adjacent_find(begin, begin + 3) != begin + 3;
    this->BoundaryOrder[number] = isFlat ? NoFace : faces++;
  }
}

Id CurvilinearCells::vertexAt(const std::array<Id, 3>& point) const
{
  std::array<Id, 3> p = point;
  Id one = 0; // the axes along which the points there are one
  for (int a = 0; a < 3; ++a)
  {
    const bool isLast = point[a] == this->Cells[a];
    one |= point[a] == 0 ? this->Joins.Poles[2 * a] : 0;
    one |= isLast ? this->Joins.Poles[2 * a + 1] : 0;
    p[a] = isLast && this->Joins.Rings[a] ? 0 : p[a];
  }
  const std::array<Id, 3> strides = this->pointStrides();
  Id vertex = 0;
  for (int a = 0; a < 3; ++a)
  {
    vertex += (one >> a & 1u) != 0 ? 0 : strides[a] * p[a];
  }
  return vertex;
}

std::array<Id, 4> CurvilinearCells::joinedPath(const Place& at) const
{
  std::array<Id, 3> point = at.Cell;
  std::array<Id, 4> vertices{ { this->vertexAt(point) } };
  for (int step = 0; step < 3; ++step)
  {
    ++point[at.Axes[step]];
    vertices[step + 1] = this->vertexAt(point);
  }
  return vertices;
}

int CurvilinearCells::flatStep(const Place& at) const
{
  const std::array<Id, 4> path = this->path(at);
  const auto same = std::adjacent_find(path.begin(), path.end());
  return same == path.end() ? -1 : static_cast<int>(same - path.begin());
}

int CurvilinearCells::sign(std::size_t tet) const
{
  int sign = tet % 2 == 0 ? 1 : -1;
  if (this->IsJoined)
  {
    const std::array<Id, 4> path = this->path(this->placeOf(tet));
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        sign = path[i] > path[j] ? -sign : sign;
      }
    }
  }
  return sign;
}

CurvilinearCells::HalfFace CurvilinearCells::halfFaceOf(std::size_t halfFace) const
{
  const Place of = this->placeOf(halfFace / 4);
  auto opposite = static_cast<int>(halfFace % 4);
  if (this->IsJoined)
  {
    const std::array<Id, 4> path = this->path(of);
    const int rank = opposite;
    for (int place = 0; place < 4; ++place)
    {
      opposite = rankOf(path, place) == rank ? place : opposite;
    }
  }
  return { of, opposite };
}

Id CurvilinearCells::numberOf(const HalfFace& at) const
{
  const std::array<Id, 3>& c = at.Of.Cell;
  const Id cell = c[0] + this->Cells[0] * (c[1] + this->Cells[1] * c[2]);
  const int face = this->IsJoined ? rankOf(this->path(at.Of), at.Opposite) : at.Opposite;
  return 4 * (TetsOfCell * cell + static_cast<Id>(2 * at.Of.Axes[0] + at.Of.Turn)) +
         static_cast<Id>(face);
}

bool CurvilinearCells::step(HalfFace& at) const
{
  std::array<Id, 3> cell = at.Of.Cell;
  const std::array<int, 3>& axes = at.Of.Axes;
  const int turn = at.Of.Turn;
  switch (at.Opposite)
  {
    case 0: // beyond the upper side of the first axis, where the path goes on along it at last
      if (cell[axes[0]] + 1 == this->Cells[axes[0]] && !this->Joins.Rings[axes[0]])
      {
        return false;
      }
      cell[axes[0]] = (cell[axes[0]] + 1) % this->Cells[axes[0]];
      at = { placeAlong(cell, axes[1], turn), 3 };
      return true;
    case 1:
      at = { placeAlong(cell, axes[1], 1 - turn), 1 };
      return true;
    case 2:
      at = { placeAlong(cell, axes[0], 1 - turn), 2 };
      return true;
    default: // beyond the lower side of the last axis
      if (cell[axes[2]] == 0 && !this->Joins.Rings[axes[2]])
      {
        return false;
      }
      cell[axes[2]] = (cell[axes[2]] == 0 ? this->Cells[axes[2]] : cell[axes[2]]) - 1;
      at = { placeAlong(cell, axes[2], turn), 0 };
      return true;
  }
}

// The faces opposite the two vertices in one place are one.
bool CurvilinearCells::goOn(HalfFace& at) const
{
  while (this->step(at))
  {
    const int flat = this->IsJoined ? this->flatStep(at.Of) : -1;
    if (flat < 0 || (flat != at.Opposite && flat + 1 != at.Opposite))
    {
      return true;
    }
    at.Opposite = 2 * flat + 1 - at.Opposite;
  }
  return false;
}

Id CurvilinearCells::numberOnSide(const HalfFace& at) const
{
  const int upper = at.Opposite == 0 ? 1 : 0;
  const int axis = at.Of.Axes[upper ? 0 : 2];
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return this->FirstFaces[2 * axis + upper] + 2 * (at.Of.Cell[u] + this->Cells[u] * at.Of.Cell[v]) +
         static_cast<Id>(at.Of.Turn);
}

// Of the path that begins along the axis of the side, or ends along it.
CurvilinearCells::HalfFace CurvilinearCells::onSide(Id number) const
{
  const auto side =
    static_cast<int>(std::upper_bound(this->FirstFaces.begin(), this->FirstFaces.end(), number) -
                     this->FirstFaces.begin() - 1);
  const int axis = side / 2;
  const bool upper = side % 2 != 0;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Id rest = number - this->FirstFaces[side];
  std::array<Id, 3> cell{};
  cell[axis] = upper ? this->Cells[axis] - 1 : 0;
  cell[u] = rest / 2 % this->Cells[u];
  cell[v] = rest / 2 / this->Cells[u];
  const int turn = static_cast<int>(rest % 2);
  return { placeAlong(cell, upper ? axis : (axis + 1 + turn) % 3, turn), upper ? 0 : 3 };
}

Id CurvilinearCells::boundaryHalfFace(Id number) const
{
  HalfFace at = this->onSide(number);
  const int flat = this->flatStep(at.Of);
  if (flat >= 0)
  {
    at.Opposite = 2 * flat + 1 - at.Opposite;
    this->goOn(at);
  }
  return this->numberOf(at);
}

} // namespace tetmarch
