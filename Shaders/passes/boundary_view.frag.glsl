// The boundary of the mesh: the face through which a pixel's ray enters, or the point in that face.
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec

#include "march/volume_buffers.glsl"
#include "tet/cells.glsl"
#include "tet/edge_sign.glsl"
#include "march/ray.glsl"
#include "tet/vertex_attributes.glsl"
#include "march/stored_scalar.glsl"
#include "tet/face_intersection.glsl"
#include "march/entry.glsl"
#if TETMARCH_BVH
#include "march/line_box.glsl"
#endif
#include "tet/boundary.glsl"
#if TETMARCH_ENTRY_LISTS
#include "tet/entry_lists.glsl"
#endif
#include "passes/pixel_ray.glsl"
#include "passes/fragment_ray.glsl"

uniform bool showsCoordinates; // shows the barycentrics of the entry, else the face

#if TETMARCH_ENTRY_LISTS
// The first entry.
Entry entryOf(PixelRay pixel)
{
  Entry before;
  before.depth = -NO_DEPTH;
  before.face = -1;
  int candidate = pixel.ray.firstCandidate;
  return nextCandidate(pixel.ray, before, candidate);
}
#else
// The entry into the part of the mesh that contains the ray at a depth; if it is outside, its next entry.
Entry entryOf(PixelRay pixel)
{
  Ray ray = pixel.ray;
  float depth = pixel.depthBegin;
  Entry before;
  before.depth = -NO_DEPTH;
  before.face = -1;
  Entry next = nextEntry(ray, before, true);
  int entries = 0;
  while (next.face >= 0 && next.depth <= depth && entries < mostSteps)
  {
    entries = entries + 1;
    before = next;
    next = nextEntry(ray, before, true);
  }
  if (before.face >= 0)
  {
    // In the opposite direction exits are entries: has the ray left the part that it entered last?
    Ray back = rayThrough(ray.origin, -ray.direction);
    Entry exit;
    exit.depth = -depth;
    exit.face = -1;
    exit = nextEntry(back, exit, true);
    if (exit.face < 0 || -exit.depth < before.depth)
    {
      return before;
    }
  }
  return next;
}
#endif

bool crossesBoundary(PixelRay pixel, out FaceIntersection intersection)
{
  int face = entryOf(pixel).face;
  return face >= 0 && enters(pixel.ray, uint(face), intersection);
}

// PCG-RXS-M-XS by M. O'Neill, as given by M. Jarzynski and M. Olano in "Hash Functions for GPU Rendering", Journal of
// Computer Graphics Techniques 9 (2020), no. 3: integers, so that every GL computes the same.
uint hash(uint number)
{
  uint state = number * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// From the vertices of the face, since the hierarchy reorders faces. One channel is 1, so that no colour is dark, the
// others are at least a quarter; 8 bits represent them exactly.
vec3 colorOfFace(uvec3 ids)
{
  uint bits = hash(ids.x + hash(ids.y + hash(ids.z)));
  float first = float(64u + (bits & 255u) * 3u / 4u) / 255.0;
  float second = float(64u + (bits >> 8u & 255u) * 3u / 4u) / 255.0;
  uint full = (bits >> 16u) % 3u;
  return full == 0u ? vec3(1.0, first, second) : (full == 1u ? vec3(first, 1.0, second) : vec3(first, second, 1.0));
}

void main()
{
  PixelRay pixel = seenPixelRay();
  FaceIntersection intersection;
  if (!crossesBoundary(pixel, intersection) || intersectionPoint(intersection).x >= pixel.depthEnd)
  {
    discard;
  }
  vec3 weight = max(intersection.weight, vec3(0.0));
  vec3 barycentrics = weight / max(weight.x + weight.y + weight.z, TINY);
  gl_FragData[0] = vec4(showsCoordinates ? barycentrics : colorOfFace(intersection.id), 1.0);
}
