// A list of rays: those samples of a grid that the next coarser grid lacks and that are to be traced.
//
// Each coarse sample has three new neighbours: right (1), above (2), and right above (4); a texel of newRayTexture
// holds the bits of those that are traced. A pyramid counts them (Ziegler, Tevs, Theobalt and Seidel 2006, "GPU point
// list generation through histogram pyramids"): texels of level 1 are the running sums of the counts of 2 x 2 coarse
// samples, those of level k + 1 of 2 x 2 texels of level k. So rays that are neighbours in the picture are neighbours
// in the list.

#include "passes/ray_image.glsl"

uniform sampler2D newRayTexture;
uniform sampler2D oddCountTexture;  // levels 1, 3 ..., side by side
uniform sampler2D evenCountTexture; // levels 2, 4 ...
uniform int countColumns[16];       // first column of each level
uniform int numberOfLevels;         // 0: all samples of the grid are traced, and the list is the grid

int newRaysAt(ivec2 coarse) { return int(texelFetch(newRayTexture, coarse, 0).x * 7.0 + 0.5); }

vec4 fetchSums(int level, ivec2 at)
{
  ivec2 texel = ivec2(at.x + countColumns[level], at.y);
  return (level & 1) == 1 ? texelFetch(oddCountTexture, texel, 0) : texelFetch(evenCountTexture, texel, 0);
}

int countOfList() { return int(fetchSums(numberOfLevels, ivec2(0)).w); }

int sumBefore(int child, vec4 sums) { return child == 0 ? 0 : int(sums[child - 1]); }

// The sample of a ray of the list; by rays 0, 1, 2 of a coarse sample, in the order of its bits.
ivec2 sampleOfRay(int ray)
{
  ivec2 at = ivec2(0);
  for (int level = numberOfLevels; level > 0; --level)
  {
    vec4 sums = fetchSums(level, at);
    int child = int(float(ray) >= sums.x) + int(float(ray) >= sums.y) + int(float(ray) >= sums.z);
    ray -= sumBefore(child, sums);
    at = 2 * at + ivec2(child & 1, child >> 1);
  }
  int bits = newRaysAt(at);
  bits = ray > 0 ? bits & (bits - 1) : bits;
  bits = ray > 1 ? bits & (bits - 1) : bits;
  int which = bits & -bits;
  return 2 * at + ivec2(int(which != 2), int(which != 1));
}

// The first ray of a coarse sample.
int firstRayOf(ivec2 coarse)
{
  int ray = 0;
  for (int level = 1; level <= numberOfLevels; ++level)
  {
    int child = (coarse.x & 1) + 2 * (coarse.y & 1);
    coarse >>= 1;
    ray += sumBefore(child, fetchSums(level, coarse));
  }
  return ray;
}

// Number of rows of the image that have rays.
int rowsOfList() { return 8 * ((countOfList() + (64 << squaresShift) - 1) >> (6 + squaresShift)); }

// The pixel whose ray is at a texel of the image. False if there is none.
bool findListedPixel(ivec2 at, out ivec2 pixel)
{
  if (numberOfLevels == 0)
  {
    pixel = pixelOfSample(at);
    return true;
  }
  int ray = rayOfTexel(at);
  bool isListed = ray < countOfList();
  pixel = pixelOfSample(sampleOfRay(isListed ? ray : 0));
  return isListed;
}
