// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a curvilinear grid, and their links: they follow from i, j and k, so that none
// is stored. Shaders/tet/curvilinear_cells.glsl computes the same, except that its
// links to the outside have no number.
#ifndef TetMarchMeshCurvilinearCells_h
#define TetMarchMeshCurvilinearCells_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetmarch
{

using Id = std::uint32_t;

/** Links of half-faces at the boundary are LinkOutside + the index of the boundary face. */
constexpr Id LinkOutside = 0x80000000u;

/**
 * Each hexahedron is cut into six tetrahedra (Kuhn, "Some combinatorial lemmas in topology", 1960):
 * one for each order of the axes in which a path along the edges leads from its lowest point to its
 * highest one. All faces are cut through their lowest point, so neighbours fit, and the vertices of
 * a path ascend. Cells and points are numbered as by VTK, i first. Tetrahedron 6 c + 2 a + s of
 * cell c begins along axis a; s is 0 if the next axis is a + 1 (modulo 3), else 1.
 */
class CurvilinearCells
{
public:
  static constexpr Id TetsOfCell = 6;

  CurvilinearCells() = default;
  explicit CurvilinearCells(const std::array<Id, 3>& cells)
    : Cells(cells)
  {
    for (int a = 0; a < 3; ++a)
    {
      const Id side = 2 * this->sideCells(a);
      this->FirstFaces[2 * a + 1] = this->FirstFaces[2 * a] + side;
      this->FirstFaces[2 * a + 2] = this->FirstFaces[2 * a + 1] + side;
    }
    this->BoundaryOrder.resize(this->FirstFaces[6]);
    for (Id face = 0; face < this->FirstFaces[6]; ++face)
    {
      this->BoundaryOrder[face] = face;
    }
  }

  const std::array<Id, 3>& cells() const { return this->Cells; }
  std::size_t numberOfTets() const
  {
    return std::size_t(TetsOfCell) * this->Cells[0] * this->Cells[1] * this->Cells[2];
  }
  std::size_t numberOfPoints() const
  {
    return std::size_t(this->Cells[0] + 1) * (this->Cells[1] + 1) * (this->Cells[2] + 1);
  }
  /** From a point to the next one along each axis. */
  std::array<Id, 3> pointStrides() const
  {
    return { { 1, this->Cells[0] + 1, (this->Cells[0] + 1) * (this->Cells[1] + 1) } };
  }
  Id numberOfBoundaryFaces() const { return this->FirstFaces[6]; }
  /** The number of the first triangle of each side: below and above along i, j and k. */
  const std::array<Id, 7>& firstFaces() const { return this->FirstFaces; }

  /** The points of a tetrahedron, which ascend. */
  std::array<Id, 4> tet(std::size_t number) const
  {
    const Place at = this->placeOf(number);
    const std::array<Id, 3> strides = this->pointStrides();
    std::array<Id, 4> points{};
    points[0] = at.Cell[0] + strides[1] * at.Cell[1] + strides[2] * at.Cell[2];
    for (int step = 0; step < 3; ++step)
    {
      points[step + 1] = points[step] + strides[at.Axes[step]];
    }
    return points;
  }

  /** The half-face on the other side, or LinkOutside + the index of the boundary face. */
  Id link(std::size_t halfFace) const
  {
    const Place at = this->placeOf(halfFace / 4);
    const auto tetWith = [](int first, int turn) { return static_cast<Id>(2 * first + turn); };
    const Id cell = static_cast<Id>(halfFace / 4 / TetsOfCell);
    const auto within = [&](Id tet, Id face) { return 4 * (TetsOfCell * cell + tet) + face; };
    switch (halfFace % 4)
    {
      case 0: // beyond the upper side of the first axis, where the path goes on along it at last
        return at.Cell[at.Axes[0]] + 1 < this->Cells[at.Axes[0]]
                 ? within(
                     tetWith(at.Axes[1], at.Turn) + TetsOfCell * this->cellStride(at.Axes[0]), 3)
                 : this->outside(at, at.Axes[0], 1);
      case 1:
        return within(tetWith(at.Axes[1], 1 - at.Turn), 1);
      case 2:
        return within(tetWith(at.Axes[0], 1 - at.Turn), 2);
      default: // beyond the lower side of the last axis
        return at.Cell[at.Axes[2]] > 0
                 ? within(
                     tetWith(at.Axes[2], at.Turn) - TetsOfCell * this->cellStride(at.Axes[2]), 0)
                 : this->outside(at, at.Axes[2], 0);
    }
  }

  /** For each half-face on a side of the grid its number; the index of its boundary face follows
   * from order(). */
  Id boundaryNumber(std::size_t halfFace) const
  {
    const Place at = this->placeOf(halfFace / 4);
    return halfFace % 4 == 0 ? this->numberOnSide(at, at.Axes[0], 1)
                             : this->numberOnSide(at, at.Axes[2], 0);
  }
  /** The half-face of each number. */
  Id boundaryHalfFace(Id number) const
  {
    const auto side =
      static_cast<int>(std::upper_bound(this->FirstFaces.begin(), this->FirstFaces.end(), number) -
                       this->FirstFaces.begin() - 1);
    const int axis = side / 2, upper = side % 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Id rest = number - this->FirstFaces[side];
    std::array<Id, 3> cell{};
    cell[axis] = upper ? this->Cells[axis] - 1 : 0;
    cell[u] = rest / 2 % this->Cells[u];
    cell[v] = rest / 2 / this->Cells[u];
    const int turn = static_cast<int>(rest % 2);
    // Of the path that begins along the axis, or ends along it.
    const int first = upper ? axis : (axis + 1 + turn) % 3;
    const Id tet =
      TetsOfCell * (cell[0] + this->cellStride(1) * cell[1] + this->cellStride(2) * cell[2]) +
      static_cast<Id>(2 * first + turn);
    return 4 * tet + (upper ? 0 : 3);
  }
  /** The boundary face of each number; 0, 1, ... at first. */
  const std::vector<Id>& order() const { return this->BoundaryOrder; }
  void setOrder(std::vector<Id> order) { this->BoundaryOrder = std::move(order); }

private:
  struct Place
  {
    std::array<Id, 3> Cell;
    std::array<int, 3> Axes; // of the path
    int Turn;                // s above
  };

  Place placeOf(std::size_t tet) const
  {
    const std::size_t cell = tet / TetsOfCell;
    const auto path = static_cast<int>(tet % TetsOfCell);
    const std::size_t row = cell / this->Cells[0];
    const int first = path / 2, turn = path % 2;
    const int second = (first + 1 + turn) % 3;
    return { { { static_cast<Id>(cell % this->Cells[0]), static_cast<Id>(row % this->Cells[1]),
               static_cast<Id>(row / this->Cells[1]) } },
      { { first, second, 3 - first - second } }, turn };
  }

  Id cellStride(int axis) const
  {
    return axis == 0 ? 1 : (axis == 1 ? this->Cells[0] : this->Cells[0] * this->Cells[1]);
  }
  Id sideCells(int axis) const { return this->Cells[(axis + 1) % 3] * this->Cells[(axis + 2) % 3]; }

  Id numberOnSide(const Place& at, int axis, int upper) const
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return this->FirstFaces[2 * axis + upper] + 2 * (at.Cell[u] + this->Cells[u] * at.Cell[v]) +
           static_cast<Id>(at.Turn);
  }
  Id outside(const Place& at, int axis, int upper) const
  {
    return LinkOutside + this->BoundaryOrder[this->numberOnSide(at, axis, upper)];
  }

  std::array<Id, 3> Cells{};
  std::array<Id, 7> FirstFaces{};
  std::vector<Id> BoundaryOrder;
};

} // namespace tetmarch

#endif
