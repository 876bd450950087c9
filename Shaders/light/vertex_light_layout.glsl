// Where in a texture the light of a vertex is kept: in blocks of 8 x 8 texels, VERTEX_LIGHT_ROW / 8 of them in a row.
// Vertices of neighbouring numbers are neighbours in space, so that rays from one block, which run in lockstep, cross
// much the same tetrahedra.

ivec2 texelOfVertex(uint vertex)
{
  uint block = vertex / 64u;
  uint within = vertex % 64u;
  uint blocks = uint(VERTEX_LIGHT_ROW) / 8u;
  return ivec2(uvec2(block % blocks, block / blocks) * 8u + uvec2(within % 8u, within / 8u));
}

uint vertexOfTexel(uvec2 texel)
{
  uvec2 block = texel / 8u;
  uvec2 within = texel % 8u;
  return (block.x + block.y * (uint(VERTEX_LIGHT_ROW) / 8u)) * 64u + within.x + within.y * 8u;
}
