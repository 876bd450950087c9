// The hexahedra of a curvilinear grid; Mesh/CurvilinearCells.h.
uniform int hexahedraCounts[9]; // along i, j, k; then the number of the first boundary face of each side
uniform vec2 hexahedraShares;   // one by their number along i, and along j

#if TETMARCH_JOINED_SIDES
uniform int joinedSides[9]; // 1 along i, j, k: a ring; then of each side the axes along which its points are one, 1 << axis
#endif

ivec3 hexahedraAlong() { return ivec3(hexahedraCounts[0], hexahedraCounts[1], hexahedraCounts[2]); }

#if TETMARCH_BVH
uniform usamplerBuffer boundaryOrderBuffer; // the boundary face of each number
uint fetchBoundaryOrder(int number) { return BUFFER_TEXEL(boundaryOrderBuffer, number).x; }
#endif
