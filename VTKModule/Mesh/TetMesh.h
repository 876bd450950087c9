// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh as the march needs it. Conventions that everything else relies on:
//  - The vertices of a tetrahedron are stored by ascending id. Face i is opposite vertex i.
//  - Half-face 4 t + i is face i of tetrahedron t. Its link is the half-face that it is from the
//    other side or, behind the boundary, LinkOutside + the number of the boundary face.
//  - Boundary faces turn counter-clockwise seen from outside.
#ifndef TetMarchMeshTetMesh_h
#define TetMarchMeshTetMesh_h

#include "Geometry/VolumeFrame.h"
#include "Mesh/MeshReport.h"
#include "Scalars/StoredScalar.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

using Id = std::uint32_t;

/** Added to the number of a boundary face in a link: what lies behind the half-face is outside the
 * mesh. */
constexpr Id LinkOutside = 0x80000000u;

/** So many tetrahedra have half-faces that are less than that. */
constexpr std::uint64_t MostTetsOfLinks = LinkOutside / 4;

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
  float Second; // inner node: its second child, the first follows it; leaf: its number of faces
  std::array<float, 3> HalfSize;
  float FirstFace; // inner node: -1 - axis along which its children lie, the first below
};

struct TetMesh
{
  std::vector<std::array<Id, 4>> Tets;
  std::vector<Id> Links;                        // of each half-face
  std::vector<std::array<Id, 4>> BoundaryFaces; // three vertices and the half-face inside
  std::vector<HierarchyNode> Hierarchy;         // may be empty if no ray needs it
  bool NeedsHierarchy = false;                  // rays may enter again
  std::size_t ReentryNodes = 0; // so many nodes, the first, are of faces that are not on the hull,
  std::size_t ReentryFaces = 0; // which are so many
  std::vector<Vertex> Vertices;
  std::vector<Id> TetCells;     // the cell of the grid each tetrahedron comes from
  std::vector<Id> VertexPoints; // the point of the grid each vertex is, or
                                // NumberOfPoints + c: the mean of the points of cell
                                // CenterCells[c]
  std::vector<Id> CenterCells;
  bool HasCutCells = false;      // some tetrahedra were cut from cells of other types
  bool LinksFollowCells = false; // links between tetrahedra are the same wherever the points are
  vtkIdType NumberOfPoints = 0;
  VolumeFrame Frame;
  MeshReport Report;

  Id numberOfTets() const { return static_cast<Id>(this->Tets.size()); }
  bool hasHierarchy() const { return !this->Hierarchy.empty(); }
};

/** The most cells that a ray can cross: it passes each tetrahedron once, or twice where a search
 * finds an entry again. A march that goes beyond has gone wrong and ends. */
inline int mostCellsOf(int tets) { return tets < (1 << 30) - 1 ? 2 * tets + 2 : 0x7fffffff; }

} // namespace tetmarch

#endif
