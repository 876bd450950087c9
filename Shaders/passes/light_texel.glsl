// The light of one texel: at a vertex of a mesh, or at a node of a lattice. Called by a fragment shader
// (vertex_light.frag.glsl) or a compute shader (vertex_light.comp.glsl).

#include "march/volume_buffers.glsl"
#include "tables/table_buffers.glsl"
#if TETMARCH_EFFECTS
#include "light/effect_buffer_files.glsl"
#endif
#include "march/thickness_buffers.glsl"
#include "light/light_ray_buffers.glsl"
#include "light/vertex_ray_buffers.glsl"
#include "light/vertex_light_layout.glsl"
#if TETMARCH_LIGHT_THROUGH_CUTS
#include "cuts/clipping_buffers.glsl"
#endif
#if TETMARCH_STRUCTURED
#include "structured/light_node_buffers.glsl"
#include "march/march_files.glsl"
#include "march/ray_cast.glsl"
#else
#include "march/traversal_files.glsl"
#endif
#include "light/light_ray_files.glsl"
#include "light/vertex_light.glsl"

uniform int vertexCount;

// Returns false beyond the last vertex.
bool findLight(uvec2 texel, OUT(vec4) light)
{
  uint vertex = vertexOfTexel(texel);
  if (vertex >= uint(vertexCount))
  {
    return false;
  }
  light = lightAtVertex(vertex);
  return true;
}
