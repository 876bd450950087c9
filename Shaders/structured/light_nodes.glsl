// The light between nodes.

vec4 fetchNodeLight(int i, int j, int k)
{
  return fetchVertexLight(uint(i) + uint(lightNodes.x) * (uint(j) + uint(lightNodes.y) * uint(k)));
}

// Trilinear interpolation at a position in lattice coordinates.
vec4 keptLightAt(vec3 place)
{
  vec3 q = (place - lightLow) * perLightStep;
  ivec3 node = ivec3(clamp(int(floor(q.x)), 0, lightNodes.x - 2), clamp(int(floor(q.y)), 0, lightNodes.y - 2),
    clamp(int(floor(q.z)), 0, lightNodes.z - 2));
  vec3 f = vec3(clamp(q.x - real(node.x), real(0), real(1)), clamp(q.y - real(node.y), real(0), real(1)),
    clamp(q.z - real(node.z), real(0), real(1)));
  vec4 light = vec4(real(0), real(0), real(0), real(0));
  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      real weight = (j == 0 ? real(1) - f.y : f.y) * (k == 0 ? real(1) - f.z : f.z);
      vec4 low = fetchNodeLight(node.x, node.y + j, node.z + k);
      vec4 high = fetchNodeLight(node.x + 1, node.y + j, node.z + k);
      light = light + (low + (high - low) * f.x) * weight;
    }
  }
  return light;
}
