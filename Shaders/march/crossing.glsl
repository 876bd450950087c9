// The result of crossing a cell, or a part of one.
struct Crossing
{
  int cells;   // number of cells: 0 after the first part of a cell
  bool lost;   // there was no exit
  bool onward; // there is a cell or a part behind
};
