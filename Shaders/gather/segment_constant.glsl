// Emission and absorption along a ray segment in which the scalar is constant: exact in closed form, but for light that
// changes along it.
#if TETMARCH_EFFECTS && TETMARCH_DEPENDENT
void integrateConstant(
  real tablePosition, real thickness, vec3 further, CellShades shades, INOUT(Radiance) radiance)
#elif TETMARCH_EFFECTS
void integrateConstant(
  real tablePosition, real thickness, CellShades shades, INOUT(Radiance) radiance)
#elif TETMARCH_INDEPENDENT
void integrateConstant(vec4 scalars, real thickness, INOUT(Radiance) radiance)
#elif TETMARCH_DEPENDENT
void integrateConstant(real tablePosition, real thickness, vec3 further, INOUT(Radiance) radiance)
#else
void integrateConstant(real tablePosition, real thickness, INOUT(Radiance) radiance)
#endif
{
#if TETMARCH_INDEPENDENT
  vec4 mean = independentMeanAt(scalars);
#elif TETMARCH_DEPENDENT
  vec4 mean = withDependentColor(tableValue(tablePosition), dependentColorOf(further));
#else
  vec4 value = tableValue(tablePosition);
  vec4 mean = vec4(value.x * value.w, value.y * value.w, value.z * value.w, value.w);
#endif
#if TETMARCH_EFFECTS
  Shade shade = shadeWithin(shades, real(0.5));
#endif
#if TETMARCH_GRADIENT_OPACITY
  Absorption piece = absorption(mean, thickness * shade.density);
#else
  Absorption piece = absorption(mean, thickness);
#endif
#if TETMARCH_LIGHT_ERROR
  radiance.lightError =
    radiance.lightError + radiance.transmittance * piece.absorbed * lightErrorOf(shades);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  keepPending(radiance, mean, shade.lit, piece);
#endif
#if TETMARCH_LIT
  absorb(radiance, litEmission(mean, shade.lit, radiance, piece), piece);
#else
  absorb(radiance, emission(mean), piece);
#endif
}
