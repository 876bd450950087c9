// The colours of a list of rays, by a compute shader: 8 x 8 rays per group.
#include "language.glsl"

layout(local_size_x = 64) in;

layout(binding = 0) writeonly uniform image2D pictureImage;
uniform vec4 tilePixels; // x, y, width, height in the image of the list

#include "passes/march_pixel.glsl"
#include "passes/sample_grid.glsl"
#include "passes/ray_list.glsl"

void main()
{
  ivec2 inTile = 8 * ivec2(gl_WorkGroupID.xy) + placeInGroup(gl_LocalInvocationIndex);
  ivec2 texel = ivec2(tilePixels.xy) + inTile;
  ivec2 at;
  if (inTile.x >= int(tilePixels.z) || inTile.y >= int(tilePixels.w) || !findListedPixel(texel, at))
  {
    return;
  }
  vec4 color = vec4(0.0);
  PixelRay pixel = pixelRay(viewport.xy + vec2(firstPixel + at) + 0.5);
  if (pixel.seen)
  {
    color = colorOf(pixel, marchPixel(pixel));
  }
  imageStore(pictureImage, texel, color);
}
