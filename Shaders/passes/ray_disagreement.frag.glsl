// How much each sample of a grid differs from the prediction of its neighbours in its row and in its column, in the
// channel where it differs most.
//VTK::Output::Dec

#include "passes/sample_grid.glsl"
#include "passes/predicted_color.glsl"

uniform sampler2D pictureTexture; // of the samples

vec4 sampleAt(ivec2 at) { return texelFetch(pictureTexture, clamp(at, ivec2(0), lastSample), 0); }

float largest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// Beyond an end of the row or column its last sample is repeated.
float disagreementAlong(ivec2 axis, ivec2 at, vec4 here)
{
  vec4 predicted =
    colorAmongFour(sampleAt(at - 3 * axis), sampleAt(at - axis), sampleAt(at + axis), sampleAt(at + 3 * axis));
  return largest(abs(here - predicted));
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(pictureTexture, at, 0);
  float alongX = disagreementAlong(ivec2(1, 0), at, here);
  float alongY = disagreementAlong(ivec2(0, 1), at, here);
  gl_FragData[0] = vec4(alongX, alongY, 0.0, 0.0);
}
