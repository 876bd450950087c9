// The picture: one ray per pixel.
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec
#if TETMARCH_PEELED
//VTK::DepthPeeling::Dec
#endif

#include "passes/march_pixel.glsl"
#include "passes/fragment_ray.glsl"

#if TETMARCH_PEELED
#include "passes/peeled_main.glsl"
#else
void main()
{
  PixelRay pixel = seenPixelRay();
  March march = marchPixel(pixel);
  gl_FragData[0] = colorOf(pixel, march);
#if TETMARCH_DIAGNOSTICS
  gl_FragData[1] = measuresOf(pixel, march);
  gl_FragData[2] = troubleOf(march);
#endif
}
#endif
