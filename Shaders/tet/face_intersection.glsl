// The intersection of a ray with a face, and the step through a tetrahedron from one face to the next.

struct FaceIntersection
{
  uvec3 id;    // vertices a, b, c, counter-clockwise around the ray as the viewer sees them
  vec2 a;      // their projections
  vec2 b;
  vec2 c;
  vec3 depth;  // their depths along the ray
  vec3 scalar; // their scalars
  vec3 weight; // cross(b, c), cross(c, a), cross(a, b): barycentrics of the ray's point, not normalised
#if TETMARCH_JOINED_SIDES
  int onPath;  // their places on the path of the tetrahedron ahead (joined_sides.glsl); set by placeOnPath(), then kept
#endif
#if TETMARCH_VERTEX_ATTRIBUTES
  VertexAttributes attributesA; // of the vertices; set by fetchCorners(), then kept by replaceByExit()
  VertexAttributes attributesB;
  VertexAttributes attributesC;
#endif
};

// Where a march begins.
void placeOnPath(Side side, INOUT(FaceIntersection) face)
{
#if TETMARCH_JOINED_SIDES
  face.onPath = placesOnPath(side, face.id);
#endif
}

void fetchCorners(INOUT(FaceIntersection) face)
{
#if TETMARCH_VERTEX_ATTRIBUTES
  face.attributesA = fetchAttributes(face.id.x);
  face.attributesB = fetchAttributes(face.id.y);
  face.attributesC = fetchAttributes(face.id.z);
#endif
}

#if TETMARCH_VERTEX_ATTRIBUTES
// Barycentrics of the intersection. The expressions are those of intersectionPoint(), so that a compiler finds the
// common terms.
vec3 barycentricsOf(FaceIntersection face)
{
  vec3 w = vec3(max(face.weight.x, real(0)), max(face.weight.y, real(0)), max(face.weight.z, real(0)));
  real sum = w.x + w.y + w.z;
  w = sum > real(0) ? w : vec3(real(1), real(1), real(1));
  real r = real(1) / (sum > real(0) ? sum : real(3));
  return w * r;
}

VertexAttributes attributesAt(FaceIntersection face)
{
  return interpolateAttributes(face.attributesA, face.attributesB, face.attributesC, barycentricsOf(face));
}
#endif

// Depth and scalar of the intersection.
vec2 intersectionPoint(FaceIntersection face)
{
  vec3 w = vec3(max(face.weight.x, real(0)), max(face.weight.y, real(0)), max(face.weight.z, real(0)));
  real sum = w.x + w.y + w.z;
  // The sum is 0 only if the ray misses the face: the predicate breaks the ties of three corners in line with the ray so
  // that they do not all turn the same way.
  w = sum > real(0) ? w : vec3(real(1), real(1), real(1));
  real r = real(1) / (sum > real(0) ? sum : real(3));
  vec3 z = face.depth;
  vec3 s = face.scalar;
  real depth = z.x + (w.y * (z.y - z.x) + w.z * (z.z - z.x)) * r;
  real scalar = s.x + (w.y * (s.y - s.x) + w.z * (s.z - s.x)) * r;
#if TETMARCH_POINT_SCALARS
  // On the edge opposite a corner without scalar the weight of that corner is 0, but the ray is in a cell with that
  // corner.
  real highest = largerOf(s.x, largerOf(s.y, s.z));
  scalar = isDrawn(highest) ? scalar : UNDRAWN_SCALAR;
#endif
  real nearest = smallerOf(z.x, smallerOf(z.y, z.z));
  real farthest = largerOf(z.x, largerOf(z.y, z.z));
  return vec2(largerOf(nearest, smallerOf(depth, farthest)), scalar);
}

// Whether the side of the face that the viewer sees does not depend on rounding of its corners.
bool isTurnedForSure(FaceIntersection face)
{
  vec2 ab = vec2(face.b.x - face.a.x, face.b.y - face.a.y);
  vec2 bc = vec2(face.c.x - face.b.x, face.c.y - face.b.y);
  vec2 ca = vec2(face.a.x - face.c.x, face.a.y - face.c.y);
  real longest = max(max(max(abs(ab.x), abs(ab.y)), max(abs(bc.x), abs(bc.y))), max(abs(ca.x), abs(ca.y)));
  real area = face.weight.x + face.weight.y + face.weight.z; // twice
  // The sum of the edge lengths is at most 3 sqrt(2) times the longest component.
  return area > real(5) * projectionBlur() * max(longest, projectionBlur());
}

// The rank by id, among the vertices of a tetrahedron, of that opposite its exit face: a, b or c.
int rankOfDropped(uvec3 id, uint apexId, bool dropA, bool dropB)
{
#if TETMARCH_LOOKS_AHEAD
  // All three ranks are known before the predicates are.
  int ab = id.x > id.y ? 1 : 0;
  int bc = id.y > id.z ? 1 : 0;
  int ca = id.z > id.x ? 1 : 0;
  int a = ab + 1 - ca + (id.x > apexId ? 1 : 0);
  int b = bc + 1 - ab + (id.y > apexId ? 1 : 0);
  int c = ca + 1 - bc + (id.z > apexId ? 1 : 0);
  return dropA ? a : (dropB ? b : c);
#else
  uint dropped = dropA ? id.x : (dropB ? id.y : id.z);
  return (dropped > id.x ? 1 : 0) + (dropped > id.y ? 1 : 0) + (dropped > id.z ? 1 : 0) + (dropped > apexId ? 1 : 0);
#endif
}

// Replaces the intersection by that of the face through which the ray leaves the tetrahedron with the given fourth
// vertex. Returns the index of that face in the tetrahedron, which is the rank by id of the opposite vertex, or its place
// on the path; -1 if there is none, which cannot happen with four real points.
int replaceByExit(INOUT(FaceIntersection) face, uint apexId, vec3 apex, real apexScalar)
{
  vec2 d = vec2(apex.x, apex.y);
  real crossA = edgeCross(face.a, d);
  real crossB = edgeCross(face.b, d);
  real crossC = edgeCross(face.c, d);
  bool leftA = turnsLeft(crossA, face.a, face.id.x, d, apexId);
  bool leftB = turnsLeft(crossB, face.b, face.id.y, d, apexId);
  bool leftC = turnsLeft(crossC, face.c, face.id.z, d, apexId);

  // The ray leaves between the two neighbours where the turn changes from right to left.
  bool dropA = leftC && !leftB;
  bool dropB = leftA && !leftC;
  bool dropC = leftB && !leftA;

#if TETMARCH_JOINED_SIDES
  int rank = replaceOnPath(face.onPath, dropA, dropB);
#else
  int rank = rankOfDropped(face.id, apexId, dropA, dropB);
#endif

  face.weight = vec3(dropA ? face.weight.x : (dropB ? -crossC : crossB),
    dropB ? face.weight.y : (dropC ? -crossA : crossC),
    dropC ? face.weight.z : (dropA ? -crossB : crossA));
  face.id = uvec3(dropA ? apexId : face.id.x, dropB ? apexId : face.id.y, dropC ? apexId : face.id.z);
  face.a = dropA ? d : face.a;
  face.b = dropB ? d : face.b;
  face.c = dropC ? d : face.c;
  face.depth = vec3(
    dropA ? apex.z : face.depth.x, dropB ? apex.z : face.depth.y, dropC ? apex.z : face.depth.z);
  face.scalar = vec3(dropA ? apexScalar : face.scalar.x, dropB ? apexScalar : face.scalar.y,
    dropC ? apexScalar : face.scalar.z);
#if TETMARCH_VERTEX_ATTRIBUTES
  VertexAttributes attributes = fetchAttributes(apexId);
  face.attributesA = selectAttributes(dropA, attributes, face.attributesA);
  face.attributesB = selectAttributes(dropB, attributes, face.attributesB);
  face.attributesC = selectAttributes(dropC, attributes, face.attributesC);
#endif
  return dropA || dropB || dropC ? rank : -1;
}
