// A grid of samples from the next coarser one: its samples, the rays of the list, and between them interpolated colours.
//VTK::Output::Dec

#include "passes/sample_grid.glsl"
#include "passes/ray_image.glsl"
#include "passes/predicted_color.glsl"

uniform sampler2D coarseTexture; // the samples of the coarser grid
uniform sampler2D rankTexture;   // of them: passes/ray_ranks.frag.glsl
uniform sampler2D listTexture;   // the colours of the list's rays

vec4 coarseAt(ivec2 at) { return texelFetch(coarseTexture, at, 0); }

// Halfway between the samples `before` and `before + step`; odd columns and rows are between two of the coarser grid. Where
// the row of samples ends, or their last distance is another one, between two samples.
vec4 interpolated(ivec2 before, ivec2 step)
{
  ivec2 last = lastSample + 1 >> 1;
  ivec2 farBefore = before - step;
  ivec2 farAfter = before + 2 * step;
  bool isInside = all(greaterThanEqual(min(farBefore, farAfter), ivec2(0))) && all(lessThan(max(farBefore, farAfter), last));
  vec4 begin = coarseAt(before);
  vec4 end = coarseAt(clamp(before + step, ivec2(0), last));
  vec4 amongFour = colorAmongFour(coarseAt(max(farBefore, ivec2(0))), begin, end, coarseAt(clamp(farAfter, ivec2(0), last)));
  return isInside ? amongFour : colorBetween(begin, end);
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 coarse = at >> 1;
  ivec2 odd = at & 1;
  vec2 rank = texelFetch(rankTexture, coarse, 0).xy;
  int newRays = int(rank.y * 7.0 + 0.5);
  int bit = odd.x + 2 * odd.y; // 0: a sample of the coarser grid; else 1 right, 2 above, 3 both
  bool isTraced = bit > 0 && (newRays >> (bit - 1) & 1) == 1;
  int before = newRays & (odd.y == 0 ? 0 : (odd.x == 0 ? 1 : 3));
  int ray = int(rank.x) + (before & 1) + (before >> 1);
  vec4 traced = texelFetch(listTexture, isTraced ? texelOfRay(ray) : ivec2(0), 0);
  vec4 between = interpolated(coarse, odd);
  // In the middle of a cell along both diagonals.
  vec4 across = interpolated(coarse + ivec2(odd.x * odd.y, 0), ivec2(odd.x * (1 - 2 * odd.y), odd.y));
  gl_FragData[0] = isTraced ? traced : 0.5 * (between + across);
}
