// The start of rays towards the light from a vertex.

// Returns false if the vertex belongs to no tetrahedron.
bool startsAtVertex(uint vertex, OUT(LightStart) start)
{
  uvec4 others = fetchVertexStart(vertex); // of a tetrahedron at the vertex: its other vertices, its number
  start.tet.number = others.w;
  start.tet.a = vertex;
  start.tet.b = others.x;
  start.tet.c = others.y;
  start.tet.d = others.z;
  start.point = vec3(real(0), real(0), real(0));
  if (others.w >= tetCount)
  {
    return false;
  }
  vec4 place = fetchVertex(vertex);
  vec4 sum = fetchVertex(start.tet.b) + fetchVertex(start.tet.c) + fetchVertex(start.tet.d);
  start.point = vec3(place.x, place.y, place.z);
  vec3 inwards = vec3(sum.x, sum.y, sum.z) * (real(1) / real(3)) - start.point;
  // A little inside the tetrahedron, so that the predicate finds the ray in it.
  start.point = start.point + inwards * (real(1) / real(64));
  return true;
}
