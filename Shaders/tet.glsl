// A tetrahedron; its face (a, b, c) turns counter-clockwise seen from outside, d lies behind it.
struct Tet
{
  uint number;
  uint a;
  uint b;
  uint c;
  uint d;
};
