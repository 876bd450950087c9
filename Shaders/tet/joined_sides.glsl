// Sides of a curvilinear grid that meet: where a ring closes, and at poles (Mesh/CurvilinearCells.h). Of points at one
// place, the first is the vertex of all. So the vertices along a path need not ascend, and at poles a vertex may follow
// itself: a ray crosses such a tetrahedron in no time, from one of the faces opposite the two to the other. No ray begins
// in one.

// The vertex at that place on the path of the tetrahedron ahead: the path has gone along the axes before it.
uint vertexOnPath(Side side, int place)
{
  Path path = pathOf(side.path);
  ivec3 axes = ivec3(0, 1, 2);
  ivec3 before = ivec3(equal(axes, ivec3(path.second, path.second, path.second))) +
    2 * ivec3(equal(axes, ivec3(path.last, path.last, path.last)));
  ivec3 gone = ivec3(lessThan(before, ivec3(place, place, place)));
  ivec3 count = hexahedraAlong();
  ivec3 point = side.cell + gone;
  // All bits are 1 on a side.
  ivec3 atBegin = -ivec3(equal(point, ivec3(0, 0, 0)));
  ivec3 atEnd = -ivec3(equal(point, count));
  // The axes along which its points are one.
  ivec3 one = (atBegin & ivec3(joinedSides[3], joinedSides[5], joinedSides[7])) |
    (atEnd & ivec3(joinedSides[4], joinedSides[6], joinedSides[8]));
  int all = one.x | one.y | one.z;
  point = point & ~(atEnd & -ivec3(joinedSides[0], joinedSides[1], joinedSides[2])); // around the ring
  ivec3 first = point & (ivec3(all & 1, (all >> 1) & 1, all >> 2) - ivec3(1, 1, 1));
  return uint(first.x + (count.x + 1) * (first.y + (count.y + 1) * first.z));
}

// The places of the vertices of the face before the tetrahedron ahead, two bits each. If two places have one vertex, the
// apex has the one that side.ahead tells.
int placesOnPath(Side side, uvec3 ids)
{
  uint first = vertexOnPath(side, 0);
  uint second = vertexOnPath(side, 1);
  uint third = vertexOnPath(side, 2);
  uint last = vertexOnPath(side, 3);
  int both = int(first == second) + 3 * int(second == third) + 5 * int(third == last); // the sum of two places
  uint repeated = third == last ? third : second;
  ivec3 places = ivec3(equal(ids, uvec3(second, second, second))) + 2 * ivec3(equal(ids, uvec3(third, third, third))) +
    3 * ivec3(equal(ids, uvec3(last, last, last)));
  if (both > 0)
  {
    places = places - int(side.ahead & 3u) * ivec3(equal(ids, uvec3(repeated, repeated, repeated)));
  }
  return places.x | (places.y << 2) | (places.z << 4);
}

// The place of the fourth vertex.
int apexOnPath(int places) { return (places ^ (places >> 2) ^ (places >> 4)) & 3; }

// The place of the dropped vertex, which is the index of the face opposite; the apex takes it. The path behind that face
// begins with the second vertex, or ends with the third, or has another in the middle.
int replaceOnPath(INOUT(int) places, bool dropA, bool dropB)
{
  int bits = dropA ? 0 : (dropB ? 2 : 4);
  int dropped = (places >> bits) & 3;
  places = (places ^ ((dropped ^ apexOnPath(places)) << bits)) + 21 * (int(dropped == 3) - int(dropped == 0));
  return dropped;
}
