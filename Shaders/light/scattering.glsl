// The fraction of light that the volume scatters instead of reflecting it by its surfaces: where the scalar hardly
// changes, or where there is little to see, there is no surface to speak of. The blending is that of VTK's GPU ray caster
// (VolumetricScatteringBlending, from VTK 9.2 on); scatteringBlending is half of it, 0..1. surface: opacity times the
// change of the scalar, as 0..1, over the radius of the mesh.
real scatteredFraction(real surface)
{
  real b = scatteringBlending;
  real decay = exp(real(-2) * b * surface);
  return b < real(0.5) ? real(2) * b * decay : real(2) * (real(1) - b) * decay + real(2) * b - real(1);
}
