// The light at a vertex of a mesh, or at a node of a structured volume: the transmittance towards ambient light, which is the mean over a few directions up to a radius,
// and towards each light that casts shadows. It is marched once, and kept until light or volume change.

#include "light/sphere_direction.glsl"

#if TETMARCH_OPAQUE_SHADOWS
// Whether opaque geometry stands between the vertex and light k.
bool isShadowed(uint vertex, int k) { return (fetchOpaqueShadows(vertex) >> uint(k) & 1u) != 0u; }
#endif

// The transmittance towards ambient light, then towards up to three lights; 0..1.
vec4 lightAtVertex(uint vertex)
{
#if TETMARCH_STRUCTURED
  vec4 light = vec4(real(1), real(1), real(1), real(1));
  vec3 point = pointOfNode(uvec3(vertex % uint(lightNodes.x), vertex / uint(lightNodes.x) % uint(lightNodes.y),
    vertex / uint(lightNodes.x) / uint(lightNodes.y)));
#else
  uvec4 start = fetchVertexStart(vertex); // a tetrahedron at the vertex: its other vertices, its number
  Tet tet;
  tet.number = start.w;
  tet.a = vertex;
  tet.b = start.x;
  tet.c = start.y;
  tet.d = start.z;
  vec4 light = vec4(real(1), real(1), real(1), real(1));
  if (start.w >= tetCount)
  {
    return light; // the vertex belongs to no tetrahedron
  }
  vec4 place = fetchVertex(vertex);
  vec4 others = fetchVertex(tet.b) + fetchVertex(tet.c) + fetchVertex(tet.d);
  vec3 point = vec3(place.x, place.y, place.z);
  vec3 inwards = vec3(others.x, others.y, others.z) * (real(1) / real(3)) - point;
  // A little inside the tetrahedron, so that the predicate finds the ray in it.
  point = point + inwards * (real(1) / real(64));
#endif
  real ambient = real(0);
  for (int k = 0; k < shadowSourceCount + occlusionDirectionCount; ++k)
  {
    bool fromLight = k < shadowSourceCount;
    vec4 source = fetchShadowSource(min(k, MOST_SHADOW_SOURCES - 1)); // position, 1; or unit vector to it, 0
    vec3 toLight = vec3(source.x, source.y, source.z) - point * source.w;
    real far = sqrt(dot(toLight, toLight));
    vec3 direction =
      fromLight ? toLight * (real(1) / max(far, TINY))
                : sphereDirection(k - shadowSourceCount, occlusionDirectionCount);
    real distance = fromLight ? min(source.w > real(0) ? far : NO_DEPTH, lightReach) : occlusionRadius;
#if TETMARCH_OPAQUE_SHADOWS
    // Light that opaque geometry keeps off needs no march.
    distance = fromLight && isShadowed(vertex, k) ? real(0) : distance;
#endif
#if TETMARCH_STRUCTURED
    real transmittance = transmittanceTo(point, direction, distance);
#else
    real transmittance = transmittanceTo(tet, point, direction, distance);
#endif
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
