// Hidden cells are skipped.
bool isHidden(uint cell) { return (fetchHiddenCells(cell >> 5u) >> (cell & 31u) & 1u) != 0u; }
