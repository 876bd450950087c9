// Light on the surface of constant scalar through a point (Phong, "Illumination for computer generated pictures", 1975;
// Levoy, "Display of surfaces from volume data", 1988).
//
// As in VTK's GPU ray caster the normal is opposite to the gradient, so that a dense body in thin surroundings is lit
// from outside, and surfaces are two-sided if the renderer's lighting is.

// turned: cosine of the angle between the normal and the direction of the light.
real diffuseOf(real turned) { return max(turned, -turned * backSide); }

// mirrored: cosine of the angle between the mirrored direction of the light and that of the eye.
real specularOf(real turned, real mirrored)
{
  return diffuseOf(turned) > real(0) ? pow(max(mirrored, TINY), specularPower) : real(0);
}

// A point of a surface of constant scalar.
struct SurfacePoint
{
  vec3 point;
  vec3 toEye;  // unit vector
  vec3 normal; // unit vector; 0 where the gradient is, since there is no surface
  real facing; // cosine of the angle between the normal and the direction of the eye
#if TETMARCH_SCATTERING
  real scattered; // fraction of the light
#endif
};

// Adds light i.
void shineOn(SurfacePoint at, int i, vec4 incoming, INOUT(Illumination) lit)
{
  vec4 direction = directionOfLight(i, at.point, at.toEye);
  vec3 toLight = vec3(direction.x, direction.y, direction.z);
  real turned = dot(at.normal, toLight);
  real diffuse = diffuseOf(turned);
  real specular = specularOf(turned, real(2) * turned * at.facing - dot(toLight, at.toEye));
#if TETMARCH_SCATTERING
  diffuse = diffuse + at.scattered * (real(1) - diffuse);
  specular = specular * (real(1) - at.scattered);
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

// The light for the given gradient of the scalar and opacity of the volume. The point and the unit vector to the eye
// are in the coordinates of the lights (light/light_buffers.glsl). incoming: the transmittance towards ambient light
// and towards the lights that cast shadows, 0..1 each.
Illumination illuminate(vec3 gradient, real opacity, vec3 point, vec3 toEye, vec4 incoming)
{
  Illumination lit = noIllumination();
#if TETMARCH_SAMPLED_OCCLUSION
  // Ambient light is added by samples.
#elif TETMARCH_OCCLUSION
  lit.direct.diffuse = ambientColor * incoming.x;
#else
  lit.direct.diffuse = ambientColor;
#endif
#if TETMARCH_WORLD_LIGHTS
  vec3 slope = toWorldNormal(gradient);
#else
  vec3 slope = gradient;
#endif
  real steepness = sqrt(dot(slope, slope));
  SurfacePoint at;
  at.point = point;
  at.toEye = toEye;
  at.normal = slope * (steepness > real(0) ? -real(1) / steepness : real(0));
  at.facing = dot(at.normal, toEye);
#if TETMARCH_SCATTERING
  at.scattered = scatteredFraction(sqrt(dot(gradient, gradient)) * gradientUnit * opacity);
#endif
#if TETMARCH_FEW_LIGHTS
  // With constant indices. There are five; those that are missing are black.
  shineOn(at, 0, incoming, lit);
  shineOn(at, 1, incoming, lit);
  shineOn(at, 2, incoming, lit);
  shineOn(at, 3, incoming, lit);
  shineOn(at, 4, incoming, lit);
#else
  for (int i = 0; i < LIGHT_COUNT; ++i)
  {
    shineOn(at, i, incoming, lit);
  }
#endif
  return lit;
}
