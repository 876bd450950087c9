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

/** Sides of a curvilinear grid whose points have equal places. Sides are those below and above
 * along i, j and k. */
struct JoinedSides
{
  std::array<bool, 3> Rings{}; // the sides along the axis are one, point for point
  std::array<Id, 6> Poles{}; // of each side the axes along which its points are one; bits 1 << axis

  bool any() const { return *this != JoinedSides(); }
  bool operator!=(const JoinedSides& other) const
  {
    return this->Rings != other.Rings || this->Poles != other.Poles;
  }
};

/**
 * Each hexahedron is cut into six tetrahedra (Kuhn, "Some combinatorial lemmas in topology", 1960):
 * one for each order of the axes in which a path along the edges leads from its lowest point to its
 * highest one. All faces are cut through their lowest point, so neighbours fit, and the vertices of
 * a path ascend. Cells and points are numbered as by VTK, i first. Tetrahedron 6 c + 2 a + s of
 * cell c begins along axis a; s is 0 if the next axis is a + 1 (modulo 3), else 1.
 *
 * Of points at one place, by the joined sides, the first is the vertex of all. At poles a path may
 * have one vertex twice: its tetrahedron is degenerate, no link leads to it, and its own links mean
 * nothing.
 */
class CurvilinearCells
{
public:
  static constexpr Id TetsOfCell = 6;
  /** In order(): of a triangle at a pole that is degenerate. */
  static constexpr Id NoFace = 0xffffffffu;

  CurvilinearCells() = default;
  explicit CurvilinearCells(const std::array<Id, 3>& cells, const JoinedSides& joins = {});

  const std::array<Id, 3>& cells() const { return this->Cells; }
  const JoinedSides& joins() const { return this->Joins; }
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
  /** The number of the first triangle of each side that isn't joined to another, and their end. */
  const std::array<Id, 7>& firstFaces() const { return this->FirstFaces; }

  /** The vertex at a point. */
  Id vertexAt(const std::array<Id, 3>& point) const;
  /** The vertices of a tetrahedron, which ascend. */
  std::array<Id, 4> tet(std::size_t number) const
  {
    std::array<Id, 4> vertices = this->path(this->placeOf(number));
    if (this->IsJoined)
    {
      std::sort(vertices.begin(), vertices.end());
    }
    return vertices;
  }
  /** The sign of the volume of a tetrahedron, its vertices taken as above, in a grid whose axes are
   * right-handed. */
  int sign(std::size_t tet) const;
  bool isDegenerate(std::size_t tet) const
  {
    return this->IsJoined && this->flatStep(this->placeOf(tet)) >= 0;
  }

  /** The half-face on the other side, or LinkOutside + the index of the boundary face. */
  Id link(std::size_t halfFace) const
  {
    HalfFace at = this->halfFaceOf(halfFace);
    return this->goOn(at) ? this->numberOf(at)
                          : LinkOutside + this->BoundaryOrder[this->numberOnSide(at)];
  }
  /** For each half-face on a side of the grid its number; the index of its boundary face follows
   * from order(). */
  Id boundaryNumber(std::size_t halfFace) const
  {
    HalfFace at = this->halfFaceOf(halfFace);
    this->goOn(at);
    return this->numberOnSide(at);
  }
  /** The half-face of each number whose triangle is not degenerate. */
  Id boundaryHalfFace(Id number) const;
  /** The boundary face of each number, or NoFace. */
  const std::vector<Id>& order() const { return this->BoundaryOrder; }
  void setOrder(std::vector<Id> order) { this->BoundaryOrder = std::move(order); }

private:
  struct Place
  {
    std::array<Id, 3> Cell;
    std::array<int, 3> Axes; // of the path
    int Turn;                // s above
  };
  /** That opposite vertex Opposite of the path. */
  struct HalfFace
  {
    Place Of;
    int Opposite;
  };

  Place placeOf(std::size_t tet) const
  {
    const std::size_t cell = tet / TetsOfCell;
    const auto path = static_cast<int>(tet % TetsOfCell);
    const std::size_t row = cell / this->Cells[0];
    return placeAlong(
      { { static_cast<Id>(cell % this->Cells[0]), static_cast<Id>(row % this->Cells[1]),
        static_cast<Id>(row / this->Cells[1]) } },
      path / 2, path % 2);
  }
  static Place placeAlong(const std::array<Id, 3>& cell, int first, int turn)
  {
    const int second = (first + 1 + turn) % 3;
    return { cell, { { first, second, 3 - first - second } }, turn };
  }

  /** The vertices along the path. */
  std::array<Id, 4> path(const Place& at) const
  {
    std::array<Id, 4> vertices{};
    const std::array<Id, 3> strides = this->pointStrides();
    vertices[0] = at.Cell[0] + strides[1] * at.Cell[1] + strides[2] * at.Cell[2];
    for (int step = 0; step < 3; ++step)
    {
      vertices[step + 1] = vertices[step] + strides[at.Axes[step]];
    }
    return this->IsJoined ? this->joinedPath(at) : vertices;
  }
  std::array<Id, 4> joinedPath(const Place& at) const;
  /** The first step of the path that leads from a vertex to itself; -1: none. */
  int flatStep(const Place& at) const;

  HalfFace halfFaceOf(std::size_t halfFace) const;
  Id numberOf(const HalfFace& at) const;
  /** To the half-face on the other side; false if that is outside of the grid. */
  bool step(HalfFace& at) const;
  /** Likewise, on through degenerate tetrahedra: to the one before the side if that is outside. */
  bool goOn(HalfFace& at) const;

  Id sideCells(int axis) const { return this->Cells[(axis + 1) % 3] * this->Cells[(axis + 2) % 3]; }
  Id numberOnSide(const HalfFace& at) const;
  HalfFace onSide(Id number) const;

  std::array<Id, 3> Cells{};
  JoinedSides Joins;
  bool IsJoined = false;
  std::array<Id, 7> FirstFaces{};
  std::vector<Id> BoundaryOrder;
};

} // namespace tetmarch

#endif
