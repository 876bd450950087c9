// The mesh in texture buffers; Mesh/TetMesh.h describes the conventions.
uniform samplerBuffer vertexBuffer;    // position, scalar
uniform usamplerBuffer boundaryBuffer; // three vertices counter-clockwise from outside, half-face inside
uniform int numberOfTets;
uniform int mostSteps;                 // the step guard: maximum number of tetrahedra on a ray

#define tetCount uint(numberOfTets)

vec4 fetchVertex(uint i) { return BUFFER_TEXEL(vertexBuffer, int(i)); }
#if TETMARCH_CURVILINEAR
#include "tet/curvilinear_buffers.glsl"
#define CELL_OF_TET(tet) int(tet / 6u)
#else
uniform usamplerBuffer cellBuffer; // tetrahedra; see tet/packed_cells.glsl
#define CELL_OF_TET(tet) int(tet)
#if !TETMARCH_SPLIT_CELLS
uvec4 fetchCell(uint tet) { return BUFFER_TEXEL(cellBuffer, int(tet)); }
#endif
#endif
uvec4 fetchBoundaryFace(uint face) { return BUFFER_TEXEL(boundaryBuffer, int(face)); }

#if TETMARCH_BVH
uniform samplerBuffer hierarchyBuffer; // two texels per node, see tet/boundary.glsl
uniform int bvhNodeCount;
uniform int bvhReentryNodeCount; // the first nodes cover the faces through which a ray can reenter
uniform int reentryFaceCount;    // number of these faces, the first ones
vec4 fetchBvhNode(int i) { return BUFFER_TEXEL(hierarchyBuffer, i); }
#endif

#if TETMARCH_HIDDEN_CELLS
uniform usamplerBuffer hiddenCellBuffer; // one bit per tetrahedron
uint fetchHiddenCells(uint word) { return BUFFER_TEXEL(hiddenCellBuffer, int(word)).x; }
#endif

#if !TETMARCH_POINT_SCALARS
uniform samplerBuffer cellScalarBuffer;
#if !TETMARCH_SPLIT_CELLS
float fetchCellScalar(uint tet) { return BUFFER_TEXEL(cellScalarBuffer, CELL_OF_TET(tet)).x; }
#endif
#endif

#if TETMARCH_CORNER_SCALARS
uniform samplerBuffer cornerScalarBuffer; // per tetrahedron: the scalars of its vertices, which ascend
#if !TETMARCH_SPLIT_CELLS
vec4 fetchCornerScalars(uint tet) { return BUFFER_TEXEL(cornerScalarBuffer, int(tet)); }
#endif
#endif

#if TETMARCH_COMPONENTS
uniform samplerBuffer extraScalarBuffer; // per vertex or tetrahedron: up to three extra scalars
#if TETMARCH_POINT_SCALARS
vec3 fetchExtraScalars(uint vertex) { return BUFFER_TEXEL(extraScalarBuffer, int(vertex)).xyz; }
#elif !TETMARCH_SPLIT_CELLS
vec3 fetchExtraScalars(uint tet) { return BUFFER_TEXEL(extraScalarBuffer, CELL_OF_TET(tet)).xyz; }
#endif
#endif

#if TETMARCH_SPLIT_CELLS
#include "tet/split_cell_buffers.glsl"
#endif
