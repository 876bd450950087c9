// The hexahedra of a curvilinear grid; Mesh/CurvilinearCells.h.
uniform int hexahedraCounts[9]; // along i, j, k; then the number of the first boundary face of each side
uniform vec2 hexahedraShares;   // one by their number along i, and along j

ivec3 hexahedraAlong() { return ivec3(hexahedraCounts[0], hexahedraCounts[1], hexahedraCounts[2]); }

#if TETMARCH_BVH
uniform usamplerBuffer boundaryOrderBuffer; // the boundary face of each number
uint fetchBoundaryOrder(int number) { return BUFFER_TEXEL(boundaryOrderBuffer, number).x; }
#endif
