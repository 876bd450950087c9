// The bits of newRayTexture (passes/ray_list.glsl): which new neighbours of each sample are traced. They are those of
// the sides and the middle of each cell of the grid that is refined.
//VTK::Output::Dec

#include "passes/sample_grid.glsl"

uniform sampler2D disagreementTexture; // of the samples, along x and y
uniform float pixelTolerance;          // a cell is refined if a side of it may be off by more,
uniform sampler2D edgeTexture;         // or if it has an edge (passes/edge_cells.frag.glsl)

vec2 disagreementAt(ivec2 at) { return texelFetch(disagreementTexture, clamp(at, ivec2(0), lastSample), 0).xy; }

float edgeAt(ivec2 at) { return texelFetch(edgeTexture, max(at, ivec2(0)), 0).x; }

// By the sides of a cell, from the disagreements at its corners. An edge of the picture between two samples disagrees
// with both, and a bend at a sample with that one only: there interpolation is right.
float errorOfCell(vec2 here, vec2 right, vec2 above, vec2 rightAbove)
{
  float alongX = max((0.5 * (here.x + right.x)), (0.5 * (above.x + rightAbove.x)));
  float alongY = max((0.5 * (here.y + above.y)), (0.5 * (right.y + rightAbove.y)));
  return max(alongX, alongY);
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec2 here = disagreementAt(at);
  vec2 right = disagreementAt(at + ivec2(1, 0));
  vec2 above = disagreementAt(at + ivec2(0, 1));
  float ofCell = errorOfCell(here, right, above, disagreementAt(at + ivec2(1, 1)));
  float ofCellBelow = errorOfCell(disagreementAt(at + ivec2(0, -1)), disagreementAt(at + ivec2(1, -1)), here, right);
  float ofCellLeft = errorOfCell(disagreementAt(at + ivec2(-1, 0)), here, disagreementAt(at + ivec2(-1, 1)), above);
  ofCell = max(ofCell, edgeAt(at));
  ofCellBelow = max(ofCellBelow, edgeAt(at - ivec2(0, 1)));
  ofCellLeft = max(ofCellLeft, edgeAt(at - ivec2(1, 0)));
  bvec3 isTraced = greaterThan(vec3(max(ofCell, ofCellBelow), max(ofCell, ofCellLeft), ofCell), vec3(pixelTolerance));
  // The last sample of an axis has no new neighbour there, and may itself not be one of the finer grid.
  bvec2 has = lessThan(at, lastSample);
  bvec2 stays = lessThan((2 * at - 1) * (spacing / 2), lastPixel);
  int bits = (isTraced.x && has.x && stays.y ? 1 : 0) + (isTraced.y && has.y && stays.x ? 2 : 0) +
    (isTraced.z && has.x && has.y ? 4 : 0);
  gl_FragData[0] = vec4(float(bits) / 7.0, 0.0, 0.0, 0.0);
}
