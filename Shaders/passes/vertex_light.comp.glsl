// Light at vertices by a compute shader: one texel per invocation, one block (light/vertex_light_layout.glsl) per
// group.
#include "language.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) writeonly uniform image2D lightImage;
uniform vec4 tilePixels; // x, y, width, height in the image

#include "passes/light_texel.glsl"

void main()
{
  ivec2 inTile = ivec2(gl_GlobalInvocationID.xy);
  if (inTile.x >= int(tilePixels.z) || inTile.y >= int(tilePixels.w))
  {
    return;
  }
  ivec2 at = ivec2(tilePixels.xy) + inTile;
  vec4 light;
  if (findLight(uvec2(at), light))
  {
    imageStore(lightImage, at, light);
  }
}
