// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra that a kernel marches through, as its members; part of KernelBody.h.

const TetMesh* Mesh = nullptr;
const float* CellScalars = nullptr;
uint tetCount = 0;
int bvhNodeCount = 0;
int bvhReentryNodeCount = 0;
int reentryFaceCount = 0;
vec4 fetchVertex(uint i) const
{
  const Vertex& v = Mesh->Vertices[i];
  return vec4(Real(v.X), Real(v.Y), Real(v.Z), Real(v.Scalar));
}
uvec2 fetchLink(uint halfFace) const
{
  const Link& link = Mesh->Links[halfFace];
  return uvec2(link.Tet, link.Apex);
}
uvec3 fetchBoundaryFace(uint face) const
{
  const auto& f = Mesh->BoundaryFaces[face];
  return uvec3(f[0], f[1], f[2]);
}
vec4 fetchBvhNode(int i) const
{
  const HierarchyNode& n = Mesh->Hierarchy[i / 2];
  const auto& v = i % 2 ? n.HalfSize : n.Center;
  return vec4(Real(v[0]), Real(v[1]), Real(v[2]), Real(i % 2 ? n.FirstFace : n.Second));
}
Real fetchCellScalar(uint tet) const { return Real(CellScalars[tet]); }

void useMesh(const TetMesh& mesh)
{
  Mesh = &mesh;
  tetCount = mesh.numberOfTets();
  bvhNodeCount = static_cast<int>(mesh.Hierarchy.size());
  bvhReentryNodeCount = static_cast<int>(mesh.ReentryNodes);
  reentryFaceCount = static_cast<int>(mesh.ReentryFaces);
  mostCells = mostCellsOf(mesh.numberOfTets());
}
