// Emission and absorption along a ray segment in which the scalar is constant: exact in closed form.
void integrateConstant(real tablePosition, real opticalLength, INOUT(Radiance) radiance)
{
  vec4 value = tableValue(tablePosition);
  vec4 mean = vec4(value.x * value.w, value.y * value.w, value.z * value.w, value.w);
  absorb(radiance, mean, absorption(mean, opticalLength));
}
