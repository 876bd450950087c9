// The boundary of the mesh: where rays come in.

// Whether the ray enters the mesh through a boundary face, and its crossing of that face. Boundary faces
// turn counter-clockwise seen from outside.
bool enters(Ray ray, uint boundaryFace, OUT(Crossing) face)
{
  face.id = fetchBoundaryFace(boundaryFace);
  vec4 a = fetchVertex(face.id.x);
  vec4 b = fetchVertex(face.id.y);
  vec4 c = fetchVertex(face.id.z);
  vec3 pa = project(ray, vec3(a.x, a.y, a.z));
  vec3 pb = project(ray, vec3(b.x, b.y, b.z));
  vec3 pc = project(ray, vec3(c.x, c.y, c.z));
  face.a = vec2(pa.x, pa.y);
  face.b = vec2(pb.x, pb.y);
  face.c = vec2(pc.x, pc.y);
  face.depth = vec3(pa.z, pb.z, pc.z);
  face.scalar = vec3(a.w, b.w, c.w);
  face.weight = vec3(edgeCross(face.b, face.c), edgeCross(face.c, face.a), edgeCross(face.a, face.b));
  return turnsLeft(face.weight.x, face.b, face.id.y, face.c, face.id.z) &&
    turnsLeft(face.weight.y, face.c, face.id.z, face.a, face.id.x) &&
    turnsLeft(face.weight.z, face.a, face.id.x, face.b, face.id.y);
}

#if TETMARCH_BVH
// Entries of a ray are ordered by depth, then by number of the face, so that each is found exactly once,
// even where components touch or overlap.
struct Entry
{
  real depth;
  int face; // -1: none
};

bool isBefore(real depth, int face, Entry other)
{
  return depth < other.depth || (depth == other.depth && face < other.face);
}

// The first entry after the given one, among the faces of the first nodeCount nodes, by a depth-first walk over
// the bounding volume hierarchy: nodes are stored in that order, and each inner one knows the node to go on
// with if the ray misses it. Boxes are tested by the separating axes of a line and a box, without a division.
Entry nextEntry(Ray ray, Entry after, int nodeCount)
{
  Entry best;
  best.depth = NO_DEPTH;
  best.face = -1;
  vec3 size = vec3(abs(ray.direction.x), abs(ray.direction.y), abs(ray.direction.z));
  int node = 0;
  while (node < nodeCount)
  {
    vec4 middle = fetchBvhNode(2 * node);     // centre; leaf: number of faces, else node after the subtree
    vec4 extent = fetchBvhNode(2 * node + 1); // half size; leaf: first face, else -1
    vec3 m = vec3(middle.x, middle.y, middle.z) - ray.origin;
    vec3 h = vec3(extent.x, extent.y, extent.z);
    vec3 d = ray.direction;
    real nearest = dot(m, d) - dot(h, size);
    real farthest = dot(m, d) + dot(h, size);
    bool hit = abs(d.y * m.z - d.z * m.y) <= h.y * size.z + h.z * size.y &&
      abs(d.z * m.x - d.x * m.z) <= h.z * size.x + h.x * size.z &&
      abs(d.x * m.y - d.y * m.x) <= h.x * size.y + h.y * size.x && farthest >= after.depth &&
      nearest <= best.depth;
    bool leaf = extent.w >= real(0);
    if (hit && leaf)
    {
      int first = int(extent.w);
      int end = first + int(middle.w);
      for (int i = first; i < end; ++i)
      {
        Crossing face;
        bool entered = enters(ray, uint(i), face);
        vec2 p = crossingPoint(face);
        if (entered && !isBefore(p.x, i, after) && i != after.face && isBefore(p.x, i, best))
        {
          best.depth = p.x;
          best.face = i;
        }
      }
    }
    node = hit || leaf ? node + 1 : int(middle.w);
  }
  return best;
}
#endif
