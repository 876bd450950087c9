// The mesh in texture buffers; Mesh/TetMesh.h has the conventions.
uniform samplerBuffer vertexBuffer;    // position, scalar
uniform usamplerBuffer linkBuffer;     // tetrahedron and apex behind each half-face
uniform usamplerBuffer boundaryBuffer; // three vertices counter-clockwise from outside, tetrahedron inside
uniform int numberOfTets;
uniform int mostCells;                 // the step guard: no ray crosses more tetrahedra

#define tetCount uint(numberOfTets)

vec4 fetchVertex(uint i) { return texelFetch(vertexBuffer, int(i)); }
uvec2 fetchLink(uint halfFace) { return texelFetch(linkBuffer, int(halfFace)).xy; }
uvec3 fetchBoundaryFace(uint face) { return texelFetch(boundaryBuffer, int(face)).xyz; }

#if TETMARCH_BVH
uniform samplerBuffer hierarchyBuffer; // two texels a node, see tet/boundary.glsl
uniform int bvhNodeCount;
uniform int bvhReentryNodeCount; // the first nodes: of faces by which a ray can enter again
uniform int reentryFaceCount;    // the first faces, likewise
vec4 fetchBvhNode(int i) { return texelFetch(hierarchyBuffer, i); }
#endif

#if TETMARCH_HIDDEN_CELLS
uniform usamplerBuffer hiddenCellBuffer; // a bit a tetrahedron
uint fetchHiddenCells(uint word) { return texelFetch(hiddenCellBuffer, int(word)).x; }
#endif

#if !TETMARCH_POINT_SCALARS
uniform samplerBuffer cellScalarBuffer;
float fetchCellScalar(uint tet) { return texelFetch(cellScalarBuffer, int(tet)).x; }
#endif

#if TETMARCH_COMPONENTS
uniform samplerBuffer furtherScalarBuffer; // of a vertex or of a tetrahedron: up to three beside the first
vec3 fetchFurtherScalars(uint i) { return texelFetch(furtherScalarBuffer, int(i)).xyz; }
#endif
