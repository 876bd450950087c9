// The fraction of light that the volume scatters, the rest being reflected by surfaces: there is no surface where the
// gradient or the opacity is small. The blending is that of VTK's GPU ray caster (VolumetricScatteringBlending, from
// VTK 9.2 on); scatteringBlending is half of it, 0..1. surface: opacity times the change of the scalar, in 0..1, over
// the radius of the mesh.
real scatteredFraction(real surface)
{
  real b = scatteringBlending;
  real decay = exp(real(-2) * b * surface);
  return b < real(0.5) ? real(2) * b * decay : real(2) * (real(1) - b) * decay + real(2) * b - real(1);
}
