// A pixel a vertex: how much light comes to it.
#include "language.glsl"

//VTK::Output::Dec

#include "mesh_buffers.glsl"
#include "table_buffers.glsl"
#if TETMARCH_EFFECTS
#include "effect_buffers.glsl"
#endif
#include "light_buffers.glsl"
#include "traversal_files.glsl"
#include "light_ray_files.glsl"
#include "vertex_light.glsl"

uniform int vertexCount;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int vertex = pixel.x + VERTEX_LIGHT_ROW * pixel.y;
  if (vertex >= vertexCount)
  {
    discard;
  }
  gl_FragData[0] = lightAtVertex(uint(vertex));
}
