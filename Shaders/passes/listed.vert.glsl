// A rectangle of the image of a list of rays, as two triangles, without the rows in which there are none.
#include "passes/sample_grid.glsl"
#include "passes/ray_list.glsl"

uniform vec4 tile;         // x and y of opposite corners, in normalised device coordinates
uniform float rowsOfImage; // its height

void main()
{
  bool right = gl_VertexID % 2 == 1;
  bool upper = gl_VertexID >= 2 && gl_VertexID <= 4;
  float end = numberOfLevels == 0 ? 1.0 : 2.0 * float(rowsOfList()) / rowsOfImage - 1.0;
  gl_Position = vec4(right ? tile.z : tile.x, min(upper ? tile.w : tile.y, end), 0.0, 1.0);
}
