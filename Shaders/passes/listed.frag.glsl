// The colours of a list of rays.
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec

#include "passes/march_pixel.glsl"
#include "passes/sample_grid.glsl"
#include "passes/ray_list.glsl"

void main()
{
  ivec2 at;
  if (IS_HELPER || !findListedPixel(ivec2(gl_FragCoord.xy), at))
  {
    discard;
  }
  vec4 color = vec4(0.0);
  PixelRay pixel = pixelRay(viewport.xy + vec2(firstPixel + at) + 0.5);
  if (pixel.seen)
  {
    color = colorOf(pixel, marchPixel(pixel));
  }
  gl_FragData[0] = color;
}
