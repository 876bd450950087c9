vec3 positionOf(uint vertex)
{
  vec4 v = fetchVertex(vertex);
  return vec3(v.x, v.y, v.z);
}

// How far a face of a tetrahedron may be from that of the curved cell, along the ray.
real shiftOf(Ray ray, FaceIntersection face)
{
  vec3 a = positionOf(face.id.x);
  vec3 normal = cross(positionOf(face.id.y) - a, positionOf(face.id.z) - a);
  return curvedDeparture.x * length(normal) / max(abs(dot(normal, ray.direction)), TINY);
}
