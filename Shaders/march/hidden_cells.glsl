// Hidden cells are passed as if nothing was in them.
bool isHidden(uint cell) { return (fetchHiddenCells(cell >> 5u) >> (cell & 31u) & 1u) != 0u; }
