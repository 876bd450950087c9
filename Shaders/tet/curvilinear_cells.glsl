// The tetrahedra of a curvilinear grid follow from i, j, k (Mesh/CurvilinearCells.h). As tet/packed_cells.glsl.
// Without a choice by `?:` where there is another way: SwiftShader needs minutes to compile a dozen of them.

// A face seen from the ray's side. Face f of a tetrahedron is opposite vertex f of its path; as in packed cells that is
// the rank of the vertex by id, unless sides are joined.
struct Side
{
  uint ahead; // half-face of the tetrahedron that the ray enters; LINK_OUTSIDE: none
  uint link;  // the half-face on the side that the ray has left
  ivec3 cell; // the hexahedron ahead
  int path;   // the tetrahedron in it: 2 * its first axis + its turn
};

// The axes of a path through a hexahedron.
struct Path
{
  int first;
  int second;
  int last;
  int turn;
};

bool isOutside(uint halfFace) { return halfFace >= LINK_OUTSIDE; }

Path pathOf(int number)
{
  Path path;
  path.turn = number & 1;
  path.first = number >> 1;
  path.second = path.first + 1 + path.turn;
  path.second = path.second - 3 * int(path.second > 2);
  path.last = 3 - path.first - path.second;
  return path;
}

// n / divisor, whose reciprocal is given.
int quotientOf(int n, int divisor, float reciprocal)
{
  int q = int(float(n) * reciprocal);
  q = q + int(floor(float(n - q * divisor) * reciprocal));
  int rest = n - q * divisor;
  return q - int(rest < 0) + int(rest >= divisor);
}

#if TETMARCH_JOINED_SIDES
#include "tet/joined_sides.glsl"
#endif

Side sideFrom(uint link, uint ahead)
{
  Side side;
  side.ahead = ahead;
  side.link = link;
  int number = int((ahead >> 2u) / 6u);
  side.path = int(ahead >> 2u) - 6 * number;
  ivec3 count = hexahedraAlong();
  int row = quotientOf(number, count.x, hexahedraShares.x);
  int layer = quotientOf(row, count.y, hexahedraShares.y);
  side.cell = ivec3(number - row * count.x, row - layer * count.y, layer);
  return side;
}

// The fourth vertex of the tetrahedron ahead.
uint apexOf(uvec4 cell, Side side, uvec3 ids)
{
#if TETMARCH_JOINED_SIDES
  return vertexOnPath(side, apexOnPath(placesOnPath(side, ids)));
#else
  Path path = pathOf(side.path);
  ivec3 count = hexahedraAlong();
  ivec3 strides = ivec3(1, count.x + 1, (count.x + 1) * (count.y + 1));
  int lowest = side.cell.x + strides.y * side.cell.y + strides.z * side.cell.z;
  int highest = lowest + strides.x + strides.y + strides.z;
  int second = lowest + strides[path.first];
  int third = highest - strides[path.last];
  return uint(lowest ^ second ^ third ^ highest) ^ ids.x ^ ids.y ^ ids.z;
#endif
}

uvec4 cellAhead(Side side) { return uvec4(0u, 0u, 0u, 0u); }

// The side of another face of the tetrahedron ahead.
Side sideOf(uvec4 cell, Side side, uint face)
{
  side.ahead = (side.ahead & ~3u) + face;
  return side;
}

// The other side of a face of the tetrahedron ahead, where the ray leaves it: a path that begins elsewhere, in the next
// hexahedron if the face is the first one or the last.
Side sideBehind(uvec4 cell, Side side, uint face)
{
  Path path = pathOf(side.path);
  ivec3 count = hexahedraAlong();
  int f = int(face);
  int within = int(f == 1 || f == 2);
  int axis = ivec4(path.first, path.last, path.last, path.last)[f];
  int step = int(f == 0) - int(f == 3);
  int first = ivec4(path.second, path.second, path.first, path.last)[f];
  Side behind;
  behind.link = (side.ahead & ~3u) + face;
  behind.path = 2 * first + abs(within - path.turn);
  int place = side.cell[axis] + step;
#if TETMARCH_JOINED_SIDES
  int around = joinedSides[axis] * count[axis] * (int(place < 0) - int(place >= count[axis]));
  place = place + around;
  step = step + around;
#endif
  behind.cell = side.cell + step * ivec3(equal(ivec3(axis, axis, axis), ivec3(0, 1, 2)));
  int stride = ivec3(1, count.x, count.x * count.y)[axis];
  int ahead = int(side.ahead & ~3u) + 4 * (6 * step * stride + behind.path - side.path) +
    within * (2 * f - 3) + 3 - f;
  behind.ahead = place < 0 || place >= count[axis] ? LINK_OUTSIDE : uint(ahead);
  return behind;
}

#if TETMARCH_BVH
// The boundary face through which the ray has left.
int boundaryFaceAhead(Side side)
{
  Side left = sideFrom(0u, side.link);
  Path path = pathOf(left.path);
  ivec3 count = hexahedraAlong();
  int upper = (side.link & 3u) == 0u ? 1 : 0;
  int axis = upper == 1 ? path.first : path.last;
  int u = axis == 2 ? 0 : axis + 1;
  int v = axis == 0 ? 2 : axis - 1;
  int number = hexahedraCounts[3 + 2 * axis + upper] +
    2 * (left.cell[u] + count[u] * left.cell[v]) + path.turn;
  return int(fetchBoundaryOrder(number));
}
#endif
