// Gradients as colours: x, y and z of the direction are red, green and blue; gray represents a gradient of 0.
Illumination gradientColor(vec3 gradient)
{
  real steepness = sqrt(dot(gradient, gradient));
  vec3 direction = gradient * (steepness > real(0) ? real(0.5) / steepness : real(0));
  Illumination lit = noIllumination();
  lit.direct.specular = direction + vec3(real(0.5), real(0.5), real(0.5));
  return lit;
}
