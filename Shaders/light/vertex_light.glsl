// The light at a vertex of a mesh, or at a node of a lattice: the transmittance towards ambient light, which is the mean
// over a few directions up to a radius, and towards each light that casts shadows. It is computed once, and kept until
// light or volume change.

#include "light/sphere_direction.glsl"
#if TETMARCH_STRUCTURED
#include "structured/node_start.glsl"
#else
#include "tet/vertex_start.glsl"
#endif

#if TETMARCH_OPAQUE_SHADOWS
// Whether opaque geometry is between the vertex and light k.
bool isShadowed(uint vertex, int k) { return (fetchOpaqueShadows(vertex) >> uint(k) & 1u) != 0u; }
#endif

// The transmittance towards ambient light, then towards up to three lights; 0..1.
vec4 lightAtVertex(uint vertex)
{
  vec4 light = vec4(real(1), real(1), real(1), real(1));
  LightStart start;
  if (!startsAtVertex(vertex, start))
  {
    return light;
  }
  real ambient = real(0);
  for (int k = 0; k < shadowSourceCount + occlusionDirectionCount; ++k)
  {
    bool fromLight = k < shadowSourceCount;
    vec4 source = fetchShadowSource(min(k, MOST_SHADOW_SOURCES - 1)); // position, 1; or unit vector to it, 0
    vec3 toLight = vec3(source.x, source.y, source.z) - start.point * source.w;
    real far = sqrt(dot(toLight, toLight));
    vec3 direction =
      fromLight ? toLight * (real(1) / max(far, TINY))
                : sphereDirection(k - shadowSourceCount, occlusionDirectionCount);
    real distance = fromLight ? min(source.w > real(0) ? far : NO_DEPTH, lightReach) : occlusionRadius;
#if TETMARCH_OPAQUE_SHADOWS
    // Light blocked by opaque geometry needs no march.
    distance = fromLight && isShadowed(vertex, k) ? real(0) : distance;
#endif
    real transmittance = transmittanceTo(start, direction, distance);
    light.y = k == 0 && fromLight ? transmittance : light.y;
    light.z = k == 1 && fromLight ? transmittance : light.z;
    light.w = k == 2 && fromLight ? transmittance : light.w;
    ambient = ambient + (fromLight ? real(0) : transmittance);
  }
  light.x = occlusionDirectionCount > 0 ? ambient / real(occlusionDirectionCount) : real(1);
#if TETMARCH_OPAQUE_SHADOWS
  light.y = isShadowed(vertex, 0) ? real(0) : light.y;
  light.z = isShadowed(vertex, 1) ? real(0) : light.z;
  light.w = isShadowed(vertex, 2) ? real(0) : light.w;
#endif
  return light;
}
