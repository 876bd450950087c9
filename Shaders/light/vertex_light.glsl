// The light at a vertex of a mesh, or at a node of a lattice. It is computed once, and kept until light or volume
// change.

#include "light/sphere_direction.glsl"
#include "light/incoming_light.glsl"
#if TETMARCH_STRUCTURED
#include "structured/node_start.glsl"
#else
#include "tet/vertex_start.glsl"
#endif

vec4 lightAtVertex(uint vertex)
{
  LightStart start;
  if (!startsAtVertex(vertex, start))
  {
    return vec4(real(1), real(1), real(1), real(1));
  }
#if TETMARCH_OPAQUE_SHADOWS
  return incomingLight(start, fetchOpaqueShadows(vertex));
#else
  return incomingLight(start, 0u);
#endif
}
