// The picture by a compute shader: one ray per pixel, 8 x 8 per group. It writes the same as march.frag.glsl, but 0
// where that discards.
#include "language.glsl"

layout(local_size_x = 64) in;

layout(binding = 0) writeonly uniform image2D pictureImage;
#if TETMARCH_DIAGNOSTICS
layout(binding = 1) writeonly uniform image2D measureImage;
layout(binding = 2) writeonly uniform image2D troubleImage;
#endif
uniform vec4 tilePixels; // x, y, width, height in the images

#include "passes/march_pixel.glsl"
#include "passes/group_place.glsl"

void main()
{
  ivec2 inTile = 8 * ivec2(gl_WorkGroupID.xy) + placeInGroup(gl_LocalInvocationIndex);
  if (inTile.x >= int(tilePixels.z) || inTile.y >= int(tilePixels.w))
  {
    return;
  }
  ivec2 at = ivec2(tilePixels.xy) + inTile;
  vec4 color = vec4(0.0);
#if TETMARCH_DIAGNOSTICS
  vec4 measures = vec4(0.0);
  vec4 trouble = vec4(0.0);
#endif
  PixelRay pixel = pixelRay(viewport.xy + vec2(at) + 0.5);
  if (pixel.seen)
  {
    March march = marchPixel(pixel);
    color = colorOf(pixel, march);
#if TETMARCH_DIAGNOSTICS
    measures = measuresOf(pixel, march);
    trouble = troubleOf(march);
#endif
  }
  imageStore(pictureImage, at, color);
#if TETMARCH_DIAGNOSTICS
  imageStore(measureImage, at, measures);
  imageStore(troubleImage, at, trouble);
#endif
}
