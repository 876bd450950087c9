// A rectangle of the viewport as two triangles. The first one alone may cover the viewport.
uniform vec4 tile; // x and y of opposite corners, in normalised device coordinates

void main()
{
  bool right = gl_VertexID % 2 == 1;
  bool upper = gl_VertexID >= 2 && gl_VertexID <= 4;
  gl_Position = vec4(right ? tile.z : tile.x, upper ? tile.w : tile.y, 0.0, 1.0);
}
