// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of the march. Conventions on which all other code relies:
//  - The vertices of a tetrahedron are stored by ascending id. Face i is opposite vertex i.
//  - Half-face 4 t + i is face i of tetrahedron t. Its link is the half-face on the other side or,
//    at the boundary, LinkOutside + the index of the boundary face.
//  - Boundary faces turn counter-clockwise seen from outside.
#ifndef TetMarchMeshTetMesh_h
#define TetMarchMeshTetMesh_h

#include "Geometry/VolumeFrame.h"
#include "Mesh/MeshArray.h"
#include "Mesh/MeshReport.h"
#include "Scalars/StoredScalar.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** Maximum number of tetrahedra, so that all half-faces are below LinkOutside. */
constexpr std::uint64_t MostTetsOfLinks = LinkOutside / 4;

/** In lists of points and vertices: none. */
constexpr Id NoPoint = 0xffffffffu;

/** One texel on the GPU: the position in the normalised frame (VolumeFrame), and the stored scalar.
 */
struct Vertex
{
  float X, Y, Z, Scalar;
};

inline Vector3 position(const Vertex& v) { return { { double(v.X), double(v.Y), double(v.Z) } }; }

/** The point is centred and scaled in double precision before it is rounded to float. The scalar is
 * 0. */
inline Vertex vertexAt(const Vector3& point, const VolumeFrame& frame)
{
  const auto coordinate = [&](int k)
  { return static_cast<float>((point[k] - frame.Center[k]) / frame.Radius); };
  return { coordinate(0), coordinate(1), coordinate(2), 0.0f };
}

/** A node of the hierarchy of boundary faces, in depth-first order; two texels on the GPU. */
struct HierarchyNode
{
  std::array<float, 3> Center;
  float Second; // inner node: its second child (the first follows it); leaf: its number of faces
  std::array<float, 3> HalfSize;
  float FirstFace; // inner node: -1 - the axis that separates its children, the first below
};

struct TetMesh
{
  MeshArray<VerticesOfTets> Tets;
  MeshArray<LinksOfHalfFaces> Links;
  std::vector<std::array<Id, 4>> BoundaryFaces; // three vertices and the half-face inside
  std::vector<HierarchyNode> Hierarchy;         // empty until a ray needs it
  bool MayReenter = false;                      // rays may leave it and enter again
  std::size_t ReentryNodes = 0;                 // nodes [0, ReentryNodes) cover the faces that are
  std::size_t ReentryFaces = 0;                 // not on the hull; their number
  std::vector<Vertex> Vertices;
  MeshArray<CellsOfTets> TetCells;          // the grid's cell that contains each tetrahedron
  MeshArray<PointsOfVertices> VertexPoints; // the grid's point of each vertex, or
                                            // NumberOfPoints + c: the mean of the points of cell
                                            // CenterCells[c]
  std::shared_ptr<const CurvilinearCells> Curvilinear; // if these four are computed
  std::vector<Id> CenterCells;
  std::vector<Id> FirstPoints;    // of the points with equal coordinates, which have one vertex
                                  // (CoincidentPoints.h); empty if no two coincide
  bool PointsAreSeparate = false; // they have vertices of their own all the same
  bool HasCutCells = false;       // some tetrahedra were cut from cells of other types
  bool LinksFollowCells = false;  // links between tetrahedra do not depend on the points
  vtkIdType NumberOfPoints = 0;
  VolumeFrame Frame;
  MeshReport Report;

  /** Of a curvilinear grid: the tetrahedra, their links and numbers are computed. */
  void computeCells(CurvilinearCells cells)
  {
    this->Curvilinear = std::make_shared<const CurvilinearCells>(std::move(cells));
    this->Tets.compute(this->Curvilinear);
    this->Links.compute(this->Curvilinear);
    this->TetCells.compute(this->Curvilinear);
    this->VertexPoints.compute(this->Curvilinear);
  }
  Id numberOfTets() const { return static_cast<Id>(this->Tets.size()); }
  /** A tetrahedron that no ray crosses, at a pole of a curvilinear grid. */
  bool isDegenerate(std::size_t tet) const
  {
    return this->Curvilinear && this->Curvilinear->isDegenerate(tet);
  }
  bool hasHierarchy() const { return !this->Hierarchy.empty(); }
};

/** Maximum number of cells that a ray can cross: each tetrahedron once, or twice where a search
 * finds an entry again. A march that exceeds it is wrong and ends. */
inline int mostCellsOf(int tets) { return tets < (1 << 30) - 1 ? 2 * tets + 2 : 0x7fffffff; }

} // namespace tetmarch

#endif
