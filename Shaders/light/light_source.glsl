// The direction of a light and its strength at a point (in the world, from the centre of the mesh).

#if TETMARCH_HEADLIGHT_ONLY || TETMARCH_SINGLE_LIGHT
#define LIGHT_COUNT 1
#else
#define LIGHT_COUNT lightCount
#endif

// The unit vector to a light, and in w its strength without absorption by the volume. A headlight shines along the ray.
vec4 directionOfLight(int light, vec3 point, vec3 toEye)
{
#if TETMARCH_HEADLIGHT_ONLY
  return vec4(toEye.x, toEye.y, toEye.z, real(1));
#else
  vec4 place = fetchLightPlace(light); // unit vector to the light, 0; or its position, 1
#if TETMARCH_WORLD_LIGHTS
  // Attenuation and spot lights as in OpenGL.
  vec4 attenuation = fetchLightAttenuation(light); // constant, linear, quadratic; the spot's exponent
  vec4 cone = fetchLightCone(light); // direction of a spot; cosine of the cone's angle, -1 if it is no spot
  vec3 toLight = vec3(place.x, place.y, place.z) - point * place.w;
  real distance = max(sqrt(dot(toLight, toLight)), TINY);
  toLight = toLight * (real(1) / distance);
  real along = -dot(toLight, vec3(cone.x, cone.y, cone.z));
  real spot = along < cone.w ? real(0) : pow(max(along, TINY), attenuation.w);
  real strength =
    real(1) / max(attenuation.x + (attenuation.y + attenuation.z * distance) * distance, TINY);
  strength = cone.w > real(-1) ? strength * spot : strength;
  vec4 direction = vec4(toLight.x, toLight.y, toLight.z, place.w > real(0) ? strength : real(1));
#else
  vec4 direction = vec4(place.x, place.y, place.z, real(1));
#endif
#if TETMARCH_SINGLE_LIGHT
  return direction;
#else
  return isHeadlight(light) ? vec4(toEye.x, toEye.y, toEye.z, real(1)) : direction;
#endif
#endif
}
