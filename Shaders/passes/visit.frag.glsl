// The visit of each pixel's ray to the mesh, from its entry to its exit (Processes/Visits.h), and its next entry. Each
// draw computes the next visit of each ray; a ray whose entry is hidden stays before it.
#define TETMARCH_VISITS 1
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec

#include "passes/march_pixel.glsl"
#include "passes/fragment_ray.glsl"

uniform bool isFirstVisit;
uniform sampler2D nextEntryTexture; // depth and face of the entry, and the depth up to which the ray is integrated
uniform sampler2D raySoFarTexture;  // transmittance of all visits, and the candidate from which entries are searched

#if TETMARCH_ACCUMULATES_OPACITY
uniform bool knowsHidden;
uniform sampler2D hiddenTexture; // depths behind which nothing is visible, from the first drawn row
uniform int firstRow;

real hiddenFrom(ivec2 at) { return knowsHidden ? texelFetch(hiddenTexture, at - ivec2(0, firstRow), 0).x : NO_DEPTH; }
#else
real hiddenFrom(ivec2 at) { return NO_DEPTH; }
#endif

// A float represents 24 bits of an integer.
vec2 halvesOf(int number) { return vec2(float(number & 0xffff), float(number >> 16)); }
int wholeOf(vec2 halves) { return int(halves.x) + (int(halves.y) << 16); }

// 0: no entry.
int faceOf(vec4 next) { return wholeOf(next.yz) - 1; }

// 0 tells that a ray goes on nowhere.
float notZero(float depth) { return depth == 0.0 ? 1e-30 : depth; }

March marchVisit(PixelRay pixel, real done, INOUT(Traversal) traversal)
{
  float thicknessPerDepth = thicknessPerDepthAlong(pixel.ray.direction);
  March march = beginMarch(done);
  march.hiddenFrom = hiddenFrom(pixel.at);
#if TETMARCH_SAMPLED_SHADOWS
  float jitter = texelFetch(jitterTexture, pixel.at & 63, 0).x;
  marchAndSample(pixel.ray, thicknessPerDepth, pixel.depthEnd, jitter, traversal, march);
#else
  marchOn(pixel.ray, thicknessPerDepth, pixel.depthEnd, traversal, march);
#endif
  return march;
}

#if TETMARCH_ACCUMULATES_OPACITY
vec4 gatheredBy(March march, vec3 direction) { return vec4(march.radiance.color, march.radiance.transmittance); }
#elif TETMARCH_EXTREME
vec4 gatheredBy(March march, vec3 direction) { return vec4(march.radiance.extreme, 0.0, 0.0, 0.0); }
#else
vec4 gatheredBy(March march, vec3 direction)
{
  float perDepth = averages ? 1.0 : thicknessPerDepthAlong(direction);
  return vec4(valueOf(march.radiance.sum) * perDepth, valueOf(march.radiance.countedLength), 0.0, 0.0);
}
#endif

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 next = texelFetch(nextEntryTexture, at, 0);
  Entry entry;
  entry.depth = next.x;
  entry.face = faceOf(next);
  if (!isFirstVisit && entry.face < 0)
  {
    discard;
  }
  PixelRay pixel = seenPixelRay();
  vec4 soFar = texelFetch(raySoFarTexture, at, 0);
  float done = isFirstVisit ? pixel.depthBegin : next.w;
  float passed = isFirstVisit ? 1.0 : soFar.x;
  Traversal traversal = traversalAt(entry, wholeOf(soFar.yz));
  if (isFirstVisit)
  {
    traversal = traversalFrom(pixel.ray, pixel.depthBegin);
  }
  if (traversal.entry.face < 0)
  {
    discard;
  }
  March march = marchVisit(pixel, done, traversal);
  vec4 gathered = gatheredBy(march, pixel.ray.direction);
  float error = errorBound(march.radiance);
  bool goesOn = continuesBefore(traversal, pixel.depthEnd);
#if TETMARCH_ACCUMULATES_OPACITY
  passed *= gathered.w;
  bool isHidden = passed < errorTolerance; // everything behind
  error += isHidden && goesOn ? gathered.w : 0.0;
  goesOn = goesOn && !isHidden;
#endif
  int face = goesOn ? traversal.entry.face + 1 : 0;
  gl_FragData[0] = vec4(march.begin, march.done, gathered.w, error);
  gl_FragData[1] = vec4(gathered.rgb, face > 0 ? notZero(traversal.entry.depth) : 0.0);
  gl_FragData[2] = vec4(traversal.entry.depth, halvesOf(face), march.done);
  gl_FragData[3] = vec4(passed, halvesOf(candidateOf(traversal)), 0.0);
}
