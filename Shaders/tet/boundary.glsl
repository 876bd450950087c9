// The boundary of the mesh, through which rays enter.

// Whether the ray enters through a face whose vertices turn counter-clockwise seen from outside, and its intersection
// with that face.
bool entersFace(Ray ray, uvec3 ids, OUT(FaceIntersection) face)
{
  face.id = ids;
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

bool enters(Ray ray, uint boundaryFace, OUT(FaceIntersection) face)
{
  uvec4 found = fetchBoundaryFace(boundaryFace);
  return entersFace(ray, uvec3(found.x, found.y, found.z), face);
}

#if TETMARCH_BVH || TETMARCH_ENTRY_LISTS
// Entries of a ray are ordered by depth, then by the index of the face, so that each is found exactly once, even if
// components touch or overlap.
bool isBefore(real depth, int face, Entry other)
{
  return depth < other.depth || (depth == other.depth && face < other.face);
}
#endif

#if TETMARCH_BVH
// The first entry after the given one, among the faces through which a ray can reenter, or among all. The hierarchy is
// traversed near child first, so that early hits cull the nodes behind.
Entry nextEntry(Ray ray, Entry after, bool amongAll)
{
  Entry best;
  best.depth = NO_DEPTH;
  best.face = -1;
  vec3 d = ray.direction;
  vec3 size = vec3(abs(d.x), abs(d.y), abs(d.z));
  int stack[BVH_STACK];           // far children yet to be visited
  stack[0] = bvhReentryNodeCount; // the tree of the other faces
  int waiting = amongAll && bvhReentryNodeCount < bvhNodeCount ? 1 : 0;
  int node = 0;
  if (bvhReentryNodeCount == 0)
  {
    node = waiting > 0 ? 0 : -1;
    waiting = 0;
  }
  int face = 0; // the next face of the leaf to be tested, up to end
  int end = 0;
  // Nodes and faces share one loop: neighbouring rays run in lockstep, and so wait less for each other.
  while (node >= 0 || face < end)
  {
    if (face < end)
    {
      FaceIntersection intersection;
      bool entered = enters(ray, uint(face), intersection);
      vec2 p = intersectionPoint(intersection);
      if (entered && !isBefore(p.x, face, after) && face != after.face && isBefore(p.x, face, best))
      {
        best.depth = p.x;
        best.face = face;
      }
      face = face + 1;
    }
    if (face >= end && node >= 0)
    {
      vec4 middle = fetchBvhNode(2 * node);     // centre; leaf: number of faces, else second child
      vec4 extent = fetchBvhNode(2 * node + 1); // half size; leaf: first face, else -1 - axis of the cut
      vec3 m = vec3(middle.x, middle.y, middle.z) - ray.origin;
      vec3 h = vec3(extent.x, extent.y, extent.z);
      real nearest = dot(m, d) - dot(h, size);
      real farthest = dot(m, d) + dot(h, size);
      bool hit = lineMeetsBox(m, h, d, size) && farthest >= after.depth && nearest <= best.depth;
      bool leaf = extent.w >= real(0);
      int second = int(middle.w);
      face = hit && leaf ? int(extent.w) : face;
      end = hit && leaf ? face + second : face;
      real along = extent.w == real(-1) ? d.x : (extent.w == real(-2) ? d.y : d.z);
      if (hit && !leaf)
      {
        stack[waiting] = along >= real(0) ? second : node + 1;
        waiting = waiting + 1;
        node = along >= real(0) ? node + 1 : second;
      }
      else
      {
        waiting = waiting - 1;
        node = waiting >= 0 ? stack[max(waiting, 0)] : -1;
      }
    }
  }
  return best;
}
#endif
