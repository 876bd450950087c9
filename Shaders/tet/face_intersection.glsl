// The ray crosses a face, steps through the tetrahedron behind it, and crosses another.

struct FaceIntersection
{
  uvec3 id;    // vertices a, b, c, counter-clockwise around the ray as the viewer sees them
  vec2 a;      // their projections
  vec2 b;
  vec2 c;
  vec3 depth;  // their depths along the ray
  vec3 scalar; // their scalars
  vec3 weight; // cross(b, c), cross(c, a), cross(a, b): barycentric weights of the ray's point
#if TETMARCH_VERTEX_GRADIENTS
  vec3 gradientA; // of the scalar at the vertices
  vec3 gradientB;
  vec3 gradientC;
#endif
#if TETMARCH_VERTEX_LIGHT
  vec4 lightA; // that comes to the vertices: ambient, and from up to three lights that cast shadows
  vec4 lightB;
  vec4 lightC;
#endif
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  vec3 furtherA; // scalars of the vertices beside the first
  vec3 furtherB;
  vec3 furtherC;
#endif
};

#if TETMARCH_VERTEX_GRADIENTS || TETMARCH_VERTEX_LIGHT || TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
// Barycentric coordinates of the point in which the ray crosses the face; in the words of intersectionPoint(), so that
// a compiler sees that most of it is done there.
vec3 barycentricsOf(FaceIntersection face)
{
  vec3 w = vec3(max(face.weight.x, real(0)), max(face.weight.y, real(0)), max(face.weight.z, real(0)));
  real sum = w.x + w.y + w.z;
  w = sum > real(0) ? w : vec3(real(1), real(1), real(1));
  real r = real(1) / (sum > real(0) ? sum : real(3));
  return w * r;
}

// What a vertex has that stays with it while it is a corner; stepThrough() brings that of each new one.
void fetchCorners(INOUT(FaceIntersection) face)
{
#if TETMARCH_VERTEX_GRADIENTS
  face.gradientA = fetchGradient(face.id.x);
  face.gradientB = fetchGradient(face.id.y);
  face.gradientC = fetchGradient(face.id.z);
#endif
#if TETMARCH_VERTEX_LIGHT
  face.lightA = fetchVertexLight(face.id.x);
  face.lightB = fetchVertexLight(face.id.y);
  face.lightC = fetchVertexLight(face.id.z);
#endif
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  face.furtherA = fetchFurtherScalars(face.id.x);
  face.furtherB = fetchFurtherScalars(face.id.y);
  face.furtherC = fetchFurtherScalars(face.id.z);
#endif
}
#endif

#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
vec3 furtherAt(FaceIntersection face)
{
  vec3 share = barycentricsOf(face);
  return face.furtherA * share.x + face.furtherB * share.y + face.furtherC * share.z;
}
#endif

#if TETMARCH_VERTEX_GRADIENTS
vec3 gradientAt(FaceIntersection face, vec3 share)
{
  return face.gradientA * share.x + face.gradientB * share.y + face.gradientC * share.z;
}
#endif

// Scalars that are not finite are stored as UNDRAWN_SCALAR; what they touch is passed through, or has a colour of its
// own. All others lie in 0..1.
bool isDrawn(real scalar) { return scalar < real(2); }

// Depth and scalar of the point in which the ray crosses the face.
vec2 intersectionPoint(FaceIntersection face)
{
  vec3 w = vec3(max(face.weight.x, real(0)), max(face.weight.y, real(0)), max(face.weight.z, real(0)));
  real sum = w.x + w.y + w.z;
  // Never of a face that the ray crosses: ties of three corners in line with it don't turn all the same traversal.
  w = sum > real(0) ? w : vec3(real(1), real(1), real(1));
  real r = real(1) / (sum > real(0) ? sum : real(3));
  vec3 z = face.depth;
  vec3 s = face.scalar;
  real depth = z.x + (w.y * (z.y - z.x) + w.z * (z.z - z.x)) * r;
  real scalar = s.x + (w.y * (s.y - s.x) + w.z * (s.z - s.x)) * r;
#if TETMARCH_POINT_SCALARS
  // A ray through the edge opposite a corner that isn't drawn has none of it, but is in a cell that touches it.
  real highest = max(s.x, max(s.y, s.z));
  scalar = isDrawn(highest) ? scalar : UNDRAWN_SCALAR;
#endif
  return vec2(clamp(depth, min(z.x, min(z.y, z.z)), max(z.x, max(z.y, z.z))), scalar);
}

// How far a depth is from the first of two points (depth, scalar) of a ray to the second, 0..1.
real shareAt(vec2 enter, vec2 leave, real depth) { return (depth - enter.x) / (leave.x - enter.x); }

// Scalar at a depth between the points (depth, scalar) in which the ray enters and leaves a tetrahedron.
real scalarAt(vec2 enter, vec2 leave, real depth)
{
  return enter.y + (leave.y - enter.y) * shareAt(enter, leave, depth);
}

#if TETMARCH_HIDDEN_CELLS
// Hidden tetrahedra are passed through as if there was nothing in them.
bool isHidden(uint tet) { return (fetchHiddenCells(tet >> 5u) >> (tet & 31u) & 1u) != 0u; }
#endif

// Whether the viewer sees the same side of the face while its corners move by as much as rounding moves them.
bool isTurnedForSure(FaceIntersection face)
{
  vec2 ab = vec2(face.b.x - face.a.x, face.b.y - face.a.y);
  vec2 bc = vec2(face.c.x - face.b.x, face.c.y - face.b.y);
  vec2 ca = vec2(face.a.x - face.c.x, face.a.y - face.c.y);
  real longest = max(max(max(abs(ab.x), abs(ab.y)), max(abs(bc.x), abs(bc.y))), max(abs(ca.x), abs(ca.y)));
  real area = face.weight.x + face.weight.y + face.weight.z; // twice
  // The edges together are at most 3 sqrt(2) times the longest component.
  return area > real(5) * projectionBlur() * max(longest, projectionBlur());
}

// Replace the intersection by that of the face through which the ray leaves the tetrahedron whose fourth
// vertex is given. Returns the number of that face in the tetrahedron, that is, the rank by id of the
// vertex it leaves out; -1 if there is none, which no four real points can bring about.
int stepThrough(INOUT(FaceIntersection) face, uint apexId, vec3 apex, real apexScalar)
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

  uint dropped = dropA ? face.id.x : (dropB ? face.id.y : face.id.z);
  int rank = (dropped > face.id.x ? 1 : 0) + (dropped > face.id.y ? 1 : 0) +
    (dropped > face.id.z ? 1 : 0) + (dropped > apexId ? 1 : 0);

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
#if TETMARCH_VERTEX_GRADIENTS
  vec3 gradient = fetchGradient(apexId);
  face.gradientA = dropA ? gradient : face.gradientA;
  face.gradientB = dropB ? gradient : face.gradientB;
  face.gradientC = dropC ? gradient : face.gradientC;
#endif
#if TETMARCH_VERTEX_LIGHT
  vec4 light = fetchVertexLight(apexId);
  face.lightA = dropA ? light : face.lightA;
  face.lightB = dropB ? light : face.lightB;
  face.lightC = dropC ? light : face.lightC;
#endif
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  vec3 further = fetchFurtherScalars(apexId);
  face.furtherA = dropA ? further : face.furtherA;
  face.furtherB = dropB ? further : face.furtherB;
  face.furtherC = dropC ? further : face.furtherC;
#endif
  return dropA || dropB || dropC ? rank : -1;
}
