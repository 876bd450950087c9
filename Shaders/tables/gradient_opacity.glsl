// Extinction that depends on the gradient of the scalar (Levoy, "Display of surfaces from volume data", 1988): the
// factor given by a vtkVolumeProperty's gradient opacity. Its table is linear between entries and constant beyond the
// last one.
real gradientOpacity(vec3 gradient)
{
  real x = min(sqrt(dot(gradient, gradient)) * gradientOpacityScale, real(gradientOpacitySize - 1));
  int entry = int(min(x, real(gradientOpacitySize - 2)));
  real begin = fetchGradientOpacity(entry);
  return begin + (fetchGradientOpacity(entry + 1) - begin) * (x - real(entry));
}
