// Morton order, so that invocations in lockstep march side by side.
ivec2 placeInGroup(uint i)
{
  return ivec2(i & 1u | i >> 1u & 2u | i >> 2u & 4u, i >> 1u & 1u | i >> 2u & 2u | i >> 3u & 4u);
}
