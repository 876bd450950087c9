// The light of independent components: each has surfaces of its own.

// On a component's surface of constant scalar at a depth in the cell.
Light lightOfComponent(int component, CellInterval cell, real depth)
{
  Ray ray = cell.ray;
  vec3 gradient = gradientOfComponent(component, cell, depth);
#if TETMARCH_WORLD_LIGHTS
  vec3 point = toWorld(ray.origin + ray.direction * depth);
#else
  vec3 point = ray.toEye;
#endif
  return illuminate(gradient, real(0), point, ray.toEye, vec4(real(1), real(1), real(1), real(1))).direct;
}

// C tau and tau in light.
vec4 litMean(vec4 mean, Light light)
{
  return vec4(mean.x * light.diffuse.x + mean.w * light.specular.x, mean.y * light.diffuse.y + mean.w * light.specular.y,
    mean.z * light.diffuse.z + mean.w * light.specular.z, mean.w);
}
