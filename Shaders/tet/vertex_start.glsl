// The starting point of rays from a vertex towards the light.

// Returns false if the vertex belongs to no tetrahedron.
bool startsAtVertex(uint vertex, OUT(LightStart) start)
{
  uvec4 found = fetchVertexStart(vertex); // of a tetrahedron at the vertex: two vertices, link of face 3, index
  start.side = sideFrom(found.z, 4u * found.w + 3u);
  start.ids = uvec3(vertex, found.x, found.y);
  start.point = vec3(real(0), real(0), real(0));
  if (found.w >= tetCount)
  {
    return false;
  }
  uint last = apexOf(cellAhead(start.side), start.side, start.ids);
  vec4 place = fetchVertex(vertex);
  vec4 sum = fetchVertex(start.ids.y) + fetchVertex(start.ids.z) + fetchVertex(last);
  start.point = vec3(place.x, place.y, place.z);
  vec3 inwards = vec3(sum.x, sum.y, sum.z) * (real(1) / real(3)) - start.point;
  // Slightly inside the tetrahedron, so that the predicate finds the ray in it.
  start.point = start.point + inwards * (real(1) / real(64));
  return true;
}
