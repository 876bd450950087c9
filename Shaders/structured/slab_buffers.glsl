// Values that exceed one texture: slabs of layers along k, each in its own texture, those of an extra component after
// those of the previous one. Layers are numbered consecutively. Bound by GL/ValueTextures.
#if TETMARCH_MANY_SLABS
uniform sampler2DArray slabTextures[8];
#else
uniform sampler2DArray slabTextures[2];
#endif
uniform int slabLayers; // of each texture
#if TETMARCH_COMPONENTS
uniform int extraLayers[MOST_COMPONENTS - 1]; // the first one of each extra component
#endif

// Reads one texture.
#if TETMARCH_GATHERS
vec4 readSlab(sampler2DArray slab, int i, int j, int layer)
{
  return textureGather(slab, vec3(vec2(float(i + 1), float(j + 1)) * valueTexel, float(layer)));
}
#elif TETMARCH_POINT_SCALARS
vec4 readSlab(sampler2DArray slab, int i, int j, int layer)
{
  ivec2 low = clamp(ivec2(i, j), ivec2(0), lastValue.xy);
  ivec2 high = clamp(ivec2(i + 1, j + 1), ivec2(0), lastValue.xy);
  return vec4(texelFetch(slab, ivec3(low.x, high.y, layer), 0).x, texelFetch(slab, ivec3(high, layer), 0).x,
    texelFetch(slab, ivec3(high.x, low.y, layer), 0).x, texelFetch(slab, ivec3(low, layer), 0).x);
}
#else
vec4 readSlab(sampler2DArray slab, int i, int j, int layer)
{
  return texelFetch(slab, ivec3(clamp(ivec2(i, j), ivec2(0), lastValue.xy), layer), 0);
}
#endif

// An array of samplers accepts constant indices only.
vec4 readSlabs(int i, int j, int layer)
{
  if (layer < slabLayers)
  {
    return readSlab(slabTextures[0], i, j, layer);
  }
#if TETMARCH_MANY_SLABS
  if (layer < 2 * slabLayers)
  {
    return readSlab(slabTextures[1], i, j, layer - slabLayers);
  }
  if (layer < 3 * slabLayers)
  {
    return readSlab(slabTextures[2], i, j, layer - 2 * slabLayers);
  }
  if (layer < 4 * slabLayers)
  {
    return readSlab(slabTextures[3], i, j, layer - 3 * slabLayers);
  }
  if (layer < 5 * slabLayers)
  {
    return readSlab(slabTextures[4], i, j, layer - 4 * slabLayers);
  }
  if (layer < 6 * slabLayers)
  {
    return readSlab(slabTextures[5], i, j, layer - 5 * slabLayers);
  }
  if (layer < 7 * slabLayers)
  {
    return readSlab(slabTextures[6], i, j, layer - 6 * slabLayers);
  }
  return readSlab(slabTextures[7], i, j, layer - 7 * slabLayers);
#else
  return readSlab(slabTextures[1], i, j, layer - slabLayers);
#endif
}

#if TETMARCH_POINT_SCALARS
vec4 fetchValues(int i, int j, int k)
{
  return readSlabs(i, j, clamp(k, 0, lastValue.z)) * valueMap.x + vec4(valueMap.y);
}
#if TETMARCH_COMPONENTS
vec4 fetchValuesOf(int component, int i, int j, int k)
{
  if (component == 0)
  {
    return fetchValues(i, j, k);
  }
  vec2 map = extraMap[extraIndex(component)];
  return readSlabs(i, j, extraLayers[extraIndex(component)] + clamp(k, 0, lastValue.z)) * map.x + vec4(map.y);
}
#endif
#else
float fetchValue(int i, int j, int k)
{
  return readSlabs(i, j, clamp(k, 0, lastValue.z)).x * valueMap.x + valueMap.y;
}
#if TETMARCH_COMPONENTS
vec3 fetchExtraValues(int i, int j, int k)
{
  int layer = clamp(k, 0, lastValue.z);
  vec3 values =
    vec3(readSlabs(i, j, extraLayers[0] + layer).x, 0.0, 0.0) * extraMap[0].x + vec3(extraMap[0].y);
#if !TETMARCH_COLOR_AND_OPACITY
  values.y = readSlabs(i, j, extraLayers[1] + layer).x * extraMap[1].x + extraMap[1].y;
  values.z = readSlabs(i, j, extraLayers[2] + layer).x * extraMap[2].x + extraMap[2].y;
#endif
  return values;
}
#endif
#endif
