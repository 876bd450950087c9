// A tetrahedron: face (a, b, c) turns counter-clockwise seen from outside, and d is behind it. The side is that of any
// of its faces.
struct Tet
{
  Side side;
  uint a;
  uint b;
  uint c;
  uint d;
};

// The tetrahedron behind a face; vertex d is the remaining one.
Tet tetBehind(Side side, uvec3 ids)
{
  Tet tet;
  tet.side = side;
  tet.a = ids.x;
  tet.b = ids.y;
  tet.c = ids.z;
  tet.d = apexOf(cellAhead(side), side, ids);
  return tet;
}

// The side of the face opposite the apex.
Side sideOpposite(Side side, uvec3 ids, uint apex)
{
  uint face = (apex > ids.x ? 1u : 0u) + (apex > ids.y ? 1u : 0u) + (apex > ids.z ? 1u : 0u);
  return sideOf(cellAhead(side), side, face);
}

// A vertex on the picture plane of the ray.
vec2 projectedVertex(Ray ray, uint vertex)
{
  vec4 v = fetchVertex(vertex);
  vec3 p = project(ray, vec3(v.x, v.y, v.z));
  return vec2(p.x, p.y);
}

// Finds the place at which the line of the ray enters the tetrahedron. A line enters a tetrahedron of four real points
// through one face or none. Returns false if there is none, because the origin is outside by rounding.
bool entersTet(Ray ray, Tet tet, OUT(RayPosition) place)
{
  vec2 a = projectedVertex(ray, tet.a);
  vec2 b = projectedVertex(ray, tet.b);
  vec2 c = projectedVertex(ray, tet.c);
  vec2 d = projectedVertex(ray, tet.d);
  bool ab = turnsLeft(edgeCross(a, b), a, tet.a, b, tet.b);
  bool bc = turnsLeft(edgeCross(b, c), b, tet.b, c, tet.c);
  bool ca = turnsLeft(edgeCross(c, a), c, tet.c, a, tet.a);
  bool ad = turnsLeft(edgeCross(a, d), a, tet.a, d, tet.d);
  bool bd = turnsLeft(edgeCross(b, d), b, tet.b, d, tet.d);
  // (a, b, c | d), (a, d, b | c), (b, d, c | a), (c, d, a | b)
  bool first = ab && bc && ca;
  bool second = ad && !bd && !ab;
  bool third = bd && !bc && !first && !second && turnsLeft(edgeCross(d, c), d, tet.d, c, tet.c);
  uvec3 ids = uvec3(third ? tet.b : (first || second ? tet.a : tet.c), first ? tet.b : tet.d,
    second ? tet.b : (first || third ? tet.c : tet.a));
  place.side = sideOpposite(tet.side, ids, first ? tet.d : (second ? tet.c : (third ? tet.a : tet.b)));
  return entersFace(ray, ids, place.face);
}
