// A tetrahedron; its face (a, b, c) turns counter-clockwise seen from outside, d lies behind it.
struct Tet
{
  uint number;
  uint a;
  uint b;
  uint c;
  uint d;
};

// Where the viewer sees a vertex.
vec2 seenAt(Ray ray, uint vertex)
{
  vec4 v = fetchVertex(vertex);
  vec3 p = project(ray, vec3(v.x, v.y, v.z));
  return vec2(p.x, p.y);
}

// The face by which the line of the ray comes into the tetrahedron, and its link. Of four real points, a line comes in
// by one face or by none; by none if rounding leaves the origin outside.
bool entersTet(Ray ray, Tet tet, OUT(FaceIntersection) face, OUT(uvec2) link)
{
  vec2 a = seenAt(ray, tet.a);
  vec2 b = seenAt(ray, tet.b);
  vec2 c = seenAt(ray, tet.c);
  vec2 d = seenAt(ray, tet.d);
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
