// The list of rays as an image of squares of 8 x 8 rays in Morton order, so that rays in lockstep are neighbours.
#include "passes/group_place.glsl"

uniform int squaresShift; // the image has 1 << squaresShift squares a row

int rayOfTexel(ivec2 at)
{
  int x = at.x & 7;
  int y = at.y & 7;
  int inSquare = (x & 1) | (x & 2) << 1 | (x & 4) << 2 | (y & 1) << 1 | (y & 2) << 2 | (y & 4) << 3;
  return 64 * ((at.y >> 3 << squaresShift) + (at.x >> 3)) + inSquare;
}

ivec2 texelOfRay(int ray)
{
  int square = ray >> 6;
  return 8 * ivec2(square & (1 << squaresShift) - 1, square >> squaresShift) + placeInGroup(uint(ray & 63));
}
