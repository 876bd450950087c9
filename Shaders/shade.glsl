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

// Of a point at that depth of the ray with that position in the table of the transfer functions. incoming: see
// illuminate().
Shade shadeOf(Ray ray, real depth, real tablePosition, vec3 gradient, vec4 incoming)
{
  Shade shade;
#if TETMARCH_GRADIENT_OPACITY
  shade.density = gradientOpacity(gradient);
#endif
#if TETMARCH_SHOW_GRADIENTS
  shade.lit = gradientColor(gradient);
#elif TETMARCH_SHADING
#if TETMARCH_SCATTERING
  real opacity = tableValue(tablePosition).w;
#else
  real opacity = real(0);
#endif
#if TETMARCH_LOCAL_LIGHTS
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

// Light that comes through the volume to where the ray crosses the face: ambient, and from the lights that cast shadows.
vec4 incomingAt(Ray ray, Crossing face, real depth)
{
#if TETMARCH_EXACT_LIGHT
  if (hasExactLight()) // the reference looks for it
  {
    return exactIncoming(ray.origin + ray.direction * depth);
  }
#endif
#if TETMARCH_VERTEX_LIGHT
  vec3 share = crossingShares(face);
  return face.lightA * share.x + face.lightB * share.y + face.lightC * share.z;
#else
  return vec4(real(1), real(1), real(1), real(1));
#endif
}

// The shades in a tetrahedron where the ray comes in and where it leaves.
struct CellShades
{
  Shade enter;
  Shade leave;
  vec2 within;   // from where to where something is integrated: 0, 1 if all the way
  vec4 incoming; // where the ray leaves
#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
  real unsure; // how far that may be off for being interpolated between vertices
#endif
};

#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
// Half of what the light of the corners differs by.
real unsureLight(Crossing face)
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

// In the middle of a part of what is integrated.
Shade shadeWithin(CellShades shades, real share)
{
  return mixShade(
    shades.enter, shades.leave, shades.within.x + (shades.within.y - shades.within.x) * share);
}

#if TETMARCH_VERTEX_GRADIENTS
Shade shadeAtFace(Ray ray, Crossing face, real depth, real scalar, vec4 incoming)
{
  vec3 gradient = gradientAt(face, crossingShares(face));
  return shadeOf(ray, depth, scalar * tableScale + tableOffset, gradient, incoming);
}
#endif

// Where the ray comes in, at a point (depth, scalar) of the face.
CellShades beginShades(Ray ray, INOUT(Crossing) face, vec2 enter)
{
#if TETMARCH_VERTEX_GRADIENTS || TETMARCH_VERTEX_LIGHT
  fetchCorners(face);
#endif
  CellShades shades;
  shades.within = vec2(real(0), real(1));
  shades.incoming = incomingAt(ray, face, enter.x);
#if TETMARCH_VERTEX_GRADIENTS
  shades.leave = shadeAtFace(ray, face, enter.x, enter.y, shades.incoming);
#endif
  return shades;
}

// Of the tetrahedron behind the last face, by the face that it was left by. What is integrated of it are the depths
// from range.x to range.y; scalar is that of the face or of the tetrahedron.
void shadeCell(Ray ray, Crossing face, uint tet, real scalar, vec2 enter, vec2 leave, vec2 range,
  INOUT(CellShades) shades)
{
  vec4 incoming = incomingAt(ray, face, leave.x);
#if TETMARCH_VERTEX_GRADIENTS
  shades.enter = shades.leave;
  shades.leave = shadeAtFace(ray, face, leave.x, scalar, incoming);
#else
  // One gradient, and in the middle the light.
  real depth = real(0.5) * (enter.x + leave.x);
  real middle = real(0.5) * (enter.y + leave.y);
  shades.enter = shadeOf(ray, depth, middle * tableScale + tableOffset, fetchCellGradient(tet),
    (shades.incoming + incoming) * real(0.5));
  shades.leave = shades.enter;
#endif
  shades.within = vec2(range.x > enter.x ? shareAt(enter, leave, range.x) : real(0),
    range.y < leave.x ? shareAt(enter, leave, range.y) : real(1));
  shades.incoming = incoming;
#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
  shades.unsure = unsureLight(face);
#endif
}
