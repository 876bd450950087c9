// The light at the vertices of a mesh, or at the nodes of a lattice: one pixel each.
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec

#include "march/volume_buffers.glsl"
#include "tables/table_buffers.glsl"
#if TETMARCH_EFFECTS
#include "light/effect_buffer_files.glsl"
#endif
#include "march/thickness_buffers.glsl"
#include "light/light_ray_buffers.glsl"
#include "light/vertex_ray_buffers.glsl"
#include "light/vertex_light_layout.glsl"
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

void main()
{
  uint vertex = vertexOfTexel(uvec2(gl_FragCoord.xy));
  if (IS_HELPER || vertex >= uint(vertexCount))
  {
    discard;
  }
  gl_FragData[0] = lightAtVertex(vertex);
}
