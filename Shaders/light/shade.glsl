// What the effects make of the volume at a point of a ray, and between two of them.

struct Shade
{
#if TETMARCH_GRADIENT_OPACITY
  real density; // factor of the extinction
#endif
#if TETMARCH_LIT
  Illumination lit;
#endif
};

// Of a point at that depth of the ray with that scalar. incoming: see illuminate().
Shade shadeOf(Ray ray, real depth, real scalar, vec3 gradient, vec4 incoming)
{
  Shade shade;
#if TETMARCH_GRADIENT_OPACITY
  shade.density = gradientOpacity(gradient);
#endif
#if TETMARCH_SHOW_GRADIENTS
  shade.lit = gradientColor(gradient);
#elif TETMARCH_SHADING
#if TETMARCH_SCATTERING
  real opacity = tableValue(scalar * tableScale + tableOffset).w;
#else
  real opacity = real(0);
#endif
#if TETMARCH_WORLD_LIGHTS
  vec3 point = toWorld(ray.origin + ray.direction * depth);
#else
  vec3 point = ray.toEye;
#endif
  shade.lit = illuminate(gradient, opacity, point, ray.toEye, incoming);
#endif
  return shade;
}

Shade mixShade(Shade p, Shade q, real share)
{
#if TETMARCH_GRADIENT_OPACITY
  p.density = p.density + (q.density - p.density) * share;
#endif
#if TETMARCH_LIT
  p.lit = mixIllumination(p.lit, q.lit, share);
#endif
  return p;
}

// The point in which the ray crosses a face.
struct FacePoint
{
  real depth;
  real scalar; // there, or of the cell before it
#if TETMARCH_VERTEX_GRADIENTS
  vec3 gradient;
#endif
#if TETMARCH_VERTEX_LIGHT
  vec4 light; // that comes through the volume: ambient, and from the lights that cast shadows
#endif
};

FacePoint facePoint(FaceIntersection face, vec2 at)
{
  FacePoint point;
  point.depth = at.x;
  point.scalar = at.y;
#if TETMARCH_VERTEX_GRADIENTS || TETMARCH_VERTEX_LIGHT
  vec3 share = barycentricsOf(face);
#endif
#if TETMARCH_VERTEX_GRADIENTS
  point.gradient = gradientAt(face, share);
#endif
#if TETMARCH_VERTEX_LIGHT
  point.light = face.lightA * share.x + face.lightB * share.y + face.lightC * share.z;
#endif
  return point;
}

vec4 incomingAt(Ray ray, FacePoint point)
{
#if TETMARCH_EXACT_LIGHT
  if (hasExactLight()) // the reference looks for it
  {
    return exactIncoming(ray.origin + ray.direction * point.depth);
  }
#endif
#if TETMARCH_VERTEX_LIGHT
  return point.light;
#else
  return vec4(real(1), real(1), real(1), real(1));
#endif
}

// In the tetrahedron at hand.
struct CellShades
{
  FacePoint from; // where the ray comes in
  FacePoint to;   // where it leaves
  Shade enter;
  Shade leave;
  vec2 within;    // from where to where the piece lies that is gathered: 0, 1 if all the way
#if TETMARCH_VERTEX_GRADIENTS && TETMARCH_PASSES_CELLS
  bool enterKnown; // the shade where the ray comes in: that where it left the tetrahedron before
#endif
#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
  real unsure;    // how far light may be off for being interpolated between vertices
#endif
};

#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
// Half of what the light of the corners differs by.
real unsureLight(FaceIntersection face)
{
  vec4 a = face.lightA;
  vec4 b = face.lightB;
  vec4 c = face.lightC;
  real most = max(max(a.x, max(b.x, c.x)) - min(a.x, min(b.x, c.x)),
    max(a.y, max(b.y, c.y)) - min(a.y, min(b.y, c.y)));
  most = max(most, max(a.z, max(b.z, c.z)) - min(a.z, min(b.z, c.z)));
  return real(0.5) * max(most, max(a.w, max(b.w, c.w)) - min(a.w, min(b.w, c.w)));
}
#endif

// At a share of the piece.
Shade shadeWithin(CellShades shades, real share)
{
  return mixShade(
    shades.enter, shades.leave, shades.within.x + (shades.within.y - shades.within.x) * share);
}

#if TETMARCH_VERTEX_GRADIENTS
Shade shadeAtFace(Ray ray, FacePoint point)
{
  return shadeOf(ray, point.depth, point.scalar, point.gradient, incomingAt(ray, point));
}
#endif

// Where the ray comes in, at a point (depth, scalar) of the face.
CellShades beginShades(Ray ray, INOUT(FaceIntersection) face, vec2 enter)
{
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  // beginCellInterval() has fetched what is at the corners.
#elif TETMARCH_VERTEX_GRADIENTS || TETMARCH_VERTEX_LIGHT
  fetchCorners(face);
#endif
  CellShades shades;
  shades.to = facePoint(face, enter);
#if TETMARCH_VERTEX_GRADIENTS && !TETMARCH_PASSES_CELLS
  shades.leave = shadeAtFace(ray, shades.to);
#endif
  return shades;
}

// Before the next tetrahedron; seen: something of the last one was.
void beginCell(INOUT(CellShades) shades, bool seen)
{
  shades.from = shades.to;
#if TETMARCH_VERTEX_GRADIENTS && TETMARCH_PASSES_CELLS
  shades.enterKnown = seen;
#endif
}

// At the end of a tetrahedron.
void shadeCell(Ray ray, FaceIntersection face, uint tet, INOUT(CellShades) shades)
{
#if TETMARCH_VERTEX_GRADIENTS && TETMARCH_PASSES_CELLS
  int missing = shades.enterKnown ? 1 : 2;
  do
  {
    FacePoint point = shades.to;
    if (missing > 1)
    {
      point = shades.from;
#if !TETMARCH_POINT_SCALARS
      point.scalar = shades.to.scalar;
#endif
    }
    shades.enter = shades.leave;
    shades.leave = shadeAtFace(ray, point);
    missing = missing - 1;
  } while (missing > 0);
#elif TETMARCH_VERTEX_GRADIENTS
  shades.enter = shades.leave;
  shades.leave = shadeAtFace(ray, shades.to);
#else
  // One gradient, and in the middle the light.
  FacePoint from = shades.from;
  FacePoint to = shades.to;
  real depth = real(0.5) * (from.depth + to.depth);
  real scalar = real(0.5) * (from.scalar + to.scalar);
  shades.enter = shadeOf(ray, depth, scalar, fetchCellGradient(tet),
    (incomingAt(ray, from) + incomingAt(ray, to)) * real(0.5));
  shades.leave = shades.enter;
#endif
#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
  shades.unsure = unsureLight(face);
#endif
}
