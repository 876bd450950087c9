// A tetrahedron: face (a, b, c) turns counter-clockwise seen from outside, and d lies behind it.
struct Tet
{
  uint number;
  uint a;
  uint b;
  uint c;
  uint d;
};

// A vertex on the picture plane of the ray.
vec2 projectedVertex(Ray ray, uint vertex)
{
  vec4 v = fetchVertex(vertex);
  vec3 p = project(ray, vec3(v.x, v.y, v.z));
  return vec2(p.x, p.y);
}

// Finds the face by which the line of the ray enters the tetrahedron, and its link. A line enters a tetrahedron of four
// real points by one face or by none. Returns false if there is none, since rounding leaves the origin outside.
bool entersTet(Ray ray, Tet tet, OUT(FaceIntersection) face, OUT(uvec2) link)
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
  link = uvec2(tet.number, first ? tet.d : (second ? tet.c : (third ? tet.a : tet.b)));
  return entersFace(ray, ids, face);
}
