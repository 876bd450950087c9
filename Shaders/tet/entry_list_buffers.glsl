// The faces through which rays may enter, in lists per tile of pixels; Entries/EntryLists.h describes the layout.
uniform usamplerBuffer entryTileBuffer;      // the first candidate of each tile, and the end
uniform usamplerBuffer entryCandidateBuffer; // face; depth and pixels
uniform int entryTileShift;
uniform int entryTilesPerRow;
uniform vec4 entryDepthPlane;

uvec2 fetchEntryCandidate(int i) { return BUFFER_TEXEL(entryCandidateBuffer, i).xy; }

// The first candidate of a pixel and the end. The pixel is counted from the picture's lower left.
ivec2 fetchCandidateRange(ivec2 pixel)
{
  int tile = (pixel.y >> entryTileShift) * entryTilesPerRow + (pixel.x >> entryTileShift);
  return ivec2(int(BUFFER_TEXEL(entryTileBuffer, tile).x), int(BUFFER_TEXEL(entryTileBuffer, tile + 1).x));
}

// The index of a pixel, or of its square of pixels, in its tile: x, then y, 4 bits each.
uint pixelInTile(ivec2 pixel)
{
  ivec2 inTile = (pixel & ((1 << entryTileShift) - 1)) >> max(entryTileShift - 4, 0);
  return uint(inTile.y << 4 | inTile.x);
}
