// Scalars of the corners of each tetrahedron, where the scalar jumps at the faces between tetrahedra.

// The scalar of the corner with that rank by id.
real scalarOfRank(vec4 scalars, int rank)
{
  return rank < 2 ? (rank < 1 ? scalars.x : scalars.y) : (rank < 3 ? scalars.z : scalars.w);
}

// Before the ray steps through the tetrahedron ahead, whose fourth vertex is the apex: the scalars of the face become
// the tetrahedron's own. Returns the scalar of the apex.
real takeCornerScalars(vec4 scalars, uint apex, INOUT(FaceIntersection) face)
{
  uvec3 id = face.id;
  int xy = id.x > id.y ? 1 : 0;
  int yz = id.y > id.z ? 1 : 0;
  int zx = id.z > id.x ? 1 : 0;
  int x = id.x > apex ? 1 : 0;
  int y = id.y > apex ? 1 : 0;
  int z = id.z > apex ? 1 : 0;
  face.scalar = vec3(scalarOfRank(scalars, xy + 1 - zx + x), scalarOfRank(scalars, yz + 1 - xy + y),
    scalarOfRank(scalars, zx + 1 - yz + z));
  return scalarOfRank(scalars, 3 - x - y - z);
}
