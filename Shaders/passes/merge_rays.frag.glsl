// A grid of samples from the next coarser one: the samples of that, the rays of the list, and interpolated colours.
//VTK::Output::Dec

#include "passes/sample_grid.glsl"
#include "passes/ray_image.glsl"
#include "passes/predicted_color.glsl"

uniform sampler2D coarseTexture; // the samples of the coarser grid
uniform sampler2D rankTexture;   // of them: passes/ray_ranks.frag.glsl
uniform sampler2D listTexture;   // the colours of the list's rays
uniform ivec2 corner;            // of the picture in the target

vec4 coarseAt(ivec2 at) { return texelFetch(coarseTexture, at, 0); }

// The position between the samples of a cell of the coarser grid, 0..1: in the middle, but in the last cells of a row
// or column, which may be smaller.
vec2 positionIn(ivec2 coarse, ivec2 at)
{
  vec2 begin = vec2(pixelOfSample(2 * coarse));
  vec2 end = vec2(pixelOfSample(2 * coarse + 2));
  return (vec2(pixelOfSample(at)) - begin) / max(end - begin, 1.0);
}

// Among four samples in a row, in the middle of a cell in both diagonals; between the nearest where they don't exist or
// are not evenly spaced.
vec4 interpolated(ivec2 at, ivec2 coarse, ivec2 odd)
{
  ivec2 last = lastSample + 1 >> 1;
  ivec2 opposite = min(coarse + odd, last);
  vec4 here = coarseAt(coarse);
  vec4 right = coarseAt(ivec2(opposite.x, coarse.y));
  vec4 above = coarseAt(ivec2(coarse.x, opposite.y));
  vec4 rightAbove = coarseAt(opposite);
  vec2 weight = positionIn(coarse, at);
  vec4 linear = mix(mix(here, right, weight.x), mix(above, rightAbove, weight.x), weight.y);
  ivec2 low = max(coarse - odd, ivec2(0));
  ivec2 high = min(coarse + 2 * odd, last);
  vec4 cubic = 0.5 * (colorAmongFour(coarseAt(low), here, rightAbove, coarseAt(high)) +
    colorAmongFour(coarseAt(ivec2(high.x, low.y)), right, above, coarseAt(ivec2(low.x, high.y))));
  bool isEven = all(greaterThanEqual(coarse, odd)) && all(lessThan(coarse + 2 * odd, last));
  return isEven ? cubic : linear;
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy) - corner;
  ivec2 coarse = at >> 1;
  ivec2 odd = at & 1;
  vec2 rank = texelFetch(rankTexture, coarse, 0).xy;
  int newRays = int(rank.y * 7.0 + 0.5);
  int bit = odd.x + 2 * odd.y; // 0: a sample of the coarser grid; else 1 right, 2 above, 3 both
  bool isTraced = bit > 0 && (newRays >> (bit - 1) & 1) == 1;
  int before = newRays & (odd.y == 0 ? 0 : (odd.x == 0 ? 1 : 3));
  int ray = int(rank.x) + (before & 1) + (before >> 1);
  vec4 traced = texelFetch(listTexture, isTraced ? texelOfRay(ray) : ivec2(0), 0);
  gl_FragData[0] = isTraced ? traced : interpolated(at, coarse, odd);
}
