// A pixel a vertex: how much light comes to it.
#include "language.glsl"
#include "helper.glsl"

//VTK::Output::Dec

#include "mesh_buffers.glsl"
#include "table_buffers.glsl"
#if TETMARCH_EFFECTS
#include "effect_buffers.glsl"
#endif
#include "light_buffers.glsl"
#include "vertex_light_layout.glsl"
#include "traversal_files.glsl"
#include "light_ray_files.glsl"
#include "vertex_light.glsl"

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
