// Light on the surface of constant scalar through a point (Phong, "Illumination for computer generated pictures", 1975;
// Levoy, "Display of surfaces from volume data", 1988).
//
// As in VTK's GPU ray caster the normal is opposite to the gradient, so that a dense body in thin surroundings is lit
// from outside, and surfaces are two-sided if the renderer's lighting is.

// turned: cosine of the angle between the normal and the direction of the light.
real diffuseOf(real turned) { return twoSided ? abs(turned) : max(turned, real(0)); }

// mirrored: cosine of the angle between the mirrored direction of the light and that of the eye.
real specularOf(real turned, real mirrored)
{
  return diffuseOf(turned) > real(0) ? pow(max(mirrored, TINY), specularPower) : real(0);
}

// The light for the given gradient of the scalar and opacity of the volume. The point and the unit vector to the eye
// are in the coordinates of the lights (light/light_buffers.glsl). incoming: the transmittance towards ambient light
// and towards the lights that cast shadows, 0..1 each.
Illumination illuminate(vec3 gradient, real opacity, vec3 point, vec3 toEye, vec4 incoming)
{
  Illumination lit = noIllumination();
  lit.direct.diffuse = ambientColor;
#if TETMARCH_OCCLUSION
  lit.direct.diffuse = lit.direct.diffuse * incoming.x;
#endif
#if TETMARCH_WORLD_LIGHTS
  vec3 slope = toWorldNormal(gradient);
#else
  vec3 slope = gradient;
#endif
  real steepness = sqrt(dot(slope, slope));
  // Where the gradient is 0 there is no surface.
  vec3 normal = slope * (steepness > real(0) ? -real(1) / steepness : real(0));
  real facing = dot(normal, toEye);
#if TETMARCH_SCATTERING
  real scattered = scatteredFraction(sqrt(dot(gradient, gradient)) * gradientUnit * opacity);
#endif
  for (int i = 0; i < LIGHT_COUNT; ++i)
  {
    vec4 direction = directionOfLight(i, point, toEye);
    vec3 toLight = vec3(direction.x, direction.y, direction.z);
    real turned = dot(normal, toLight);
    real diffuse = diffuseOf(turned);
    real specular = specularOf(turned, real(2) * turned * facing - dot(toLight, toEye));
#if TETMARCH_SCATTERING
    diffuse = diffuse + scattered * (real(1) - diffuse);
    specular = specular * (real(1) - scattered);
#endif
    Light light;
    light.diffuse = fetchLightDiffuse(i) * (direction.w * diffuse);
    light.specular = fetchLightSpecular(i) * (direction.w * specular);
#if TETMARCH_SHADOWS
    addShadowed(lit, i, light, incoming);
#else
    lit.direct = addLight(lit.direct, light);
#endif
  }
  return lit;
}
