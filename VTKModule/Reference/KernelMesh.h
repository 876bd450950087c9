// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra that a kernel marches through, as its members; part of KernelBody.h.

const TetMesh* Mesh = nullptr;
const float* CellScalars = nullptr;
const std::array<float, 4>* CornerScalars = nullptr;
uint tetCount = 0;
int bvhNodeCount = 0;
int bvhReentryNodeCount = 0;
int reentryFaceCount = 0;
vec4 fetchVertex(uint i) const
{
  const Vertex& v = Mesh->Vertices[i];
  return vec4(Real(v.X), Real(v.Y), Real(v.Z), Real(v.Scalar));
}
uvec4 fetchCell(uint tet) const
{
  const PackedCell cell = packedCell(*Mesh, tet);
  return uvec4(cell[0], cell[1], cell[2], cell[3]);
}
uvec4 fetchBoundaryFace(uint face) const
{
  const auto& f = Mesh->BoundaryFaces[face];
  return uvec4(f[0], f[1], f[2], f[3]);
}
vec4 fetchBvhNode(int i) const
{
  const HierarchyNode& n = Mesh->Hierarchy[i / 2];
  const auto& v = i % 2 ? n.HalfSize : n.Center;
  return vec4(Real(v[0]), Real(v[1]), Real(v[2]), Real(i % 2 ? n.FirstFace : n.Second));
}
Real fetchCellScalar(uint tet) const { return Real(CellScalars[tet]); }
vec4 fetchCornerScalars(uint tet) const
{
  const auto& s = CornerScalars[tet];
  return vec4(Real(s[0]), Real(s[1]), Real(s[2]), Real(s[3]));
}

void useMesh(const TetMesh& mesh)
{
  Mesh = &mesh;
  tetCount = mesh.numberOfTets();
  bvhNodeCount = static_cast<int>(mesh.Hierarchy.size());
  bvhReentryNodeCount = static_cast<int>(mesh.ReentryNodes);
  reentryFaceCount = static_cast<int>(mesh.ReentryFaces);
  mostSteps = mostCellsOf(mesh.numberOfTets());
}

#if TETMARCH_ENTRY_LISTS
const EntryLists* Entries = nullptr;
vec4 entryDepthPlane{ 0, 0, 0, 0 };
uvec2 fetchEntryCandidate(int i) const
{
  const EntryCandidate& candidate = Entries->Candidates[i];
  return uvec2(candidate.Face, candidate.Where);
}

void useEntryLists(const EntryLists& lists)
{
  Entries = &lists;
  const auto& plane = lists.DepthPlane;
  entryDepthPlane = vec4(Real(plane[0]), Real(plane[1]), Real(plane[2]), Real(plane[3]));
}
#endif

#if TETMARCH_VISIBLE_PART
const VisiblePart* Part = nullptr;
uint fetchVisibleTets(uint word) const { return Part->Tets[word]; }
uvec4 fetchVisibleFace(uint face) const
{
  const auto& f = Part->Faces[face];
  return uvec4(f[0], f[1], f[2], f[3]);
}
uint fetchVisibleLink(uint face) const { return Part->Links[face]; }
#endif
