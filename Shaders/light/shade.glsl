// The effect of gradients and light at a point of a ray, and between two points.

struct Shade
{
#if TETMARCH_GRADIENT_OPACITY
  real density; // factor of the extinction
#endif
#if TETMARCH_LIT
  Illumination lit;
#endif
};

// The shade of a point of the ray with this depth and scalar. incoming: see illuminate().
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

// A point of the ray: an intersection with a face, or the end of an interval.
struct FacePoint
{
  real depth;
  real scalar; // at the point, or of the cell
#if TETMARCH_VERTEX_ATTRIBUTES
  VertexAttributes attributes; // interpolated
#endif
};

// The transmittance towards ambient light and towards the lights that cast shadows.
vec4 incomingAt(Ray ray, FacePoint point)
{
#if TETMARCH_EXACT_LIGHT && TETMARCH_SHADING
  if (hasExactLight())
  {
    return exactIncoming(ray.origin + ray.direction * point.depth);
  }
#endif
#if TETMARCH_VERTEX_LIGHT
  return point.attributes.light;
#else
  return vec4(real(1), real(1), real(1), real(1));
#endif
}

#if TETMARCH_VERTEX_GRADIENTS
Shade shadeAtFace(Ray ray, FacePoint point)
{
  return shadeOf(ray, point.depth, point.scalar, point.attributes.gradient, incomingAt(ray, point));
}
#endif

#if TETMARCH_LIT_PARTS
// p + (b - a) * fraction.
Shade shiftShade(Shade p, Shade a, Shade b, real fraction)
{
#if TETMARCH_GRADIENT_OPACITY
  p.density = max(p.density + (b.density - a.density) * fraction, real(0));
#endif
  p.lit = shiftIllumination(p.lit, a.lit, b.lit, fraction);
  return p;
}
#endif
