// The layout of the texture with the light of the vertices: square blocks of texels, as many in a row as fit. Vertices
// with neighbouring indices are neighbours in space, so that rays from one block, which run in lockstep, cross nearly
// the same tetrahedra.
#define BLOCK_SIDE uint(VERTEX_LIGHT_BLOCK)
#define BLOCK_TEXELS (BLOCK_SIDE * BLOCK_SIDE)
#define BLOCKS_IN_ROW (uint(VERTEX_LIGHT_ROW) / BLOCK_SIDE)

ivec2 texelOfVertex(uint vertex)
{
  uint block = vertex / BLOCK_TEXELS;
  uint within = vertex % BLOCK_TEXELS;
  return ivec2(uvec2(block % BLOCKS_IN_ROW, block / BLOCKS_IN_ROW) * BLOCK_SIDE +
    uvec2(within % BLOCK_SIDE, within / BLOCK_SIDE));
}

uint vertexOfTexel(uvec2 texel)
{
  uvec2 block = texel / BLOCK_SIDE;
  uvec2 within = texel % BLOCK_SIDE;
  return (block.x + block.y * BLOCKS_IN_ROW) * BLOCK_TEXELS + within.x + within.y * BLOCK_SIDE;
}
