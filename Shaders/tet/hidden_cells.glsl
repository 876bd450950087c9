// Hidden tetrahedra are passed as if nothing was in them.
bool isHidden(uint tet) { return (fetchHiddenCells(tet >> 5u) >> (tet & 31u) & 1u) != 0u; }
