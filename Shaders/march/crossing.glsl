// What crossing a cell, or a part of one, has come to.
struct Crossing
{
  int cells;   // that it took: 0 behind the first part of a cell
  bool lost;   // there was no exit
  bool onward; // there is a cell or a part behind
};
