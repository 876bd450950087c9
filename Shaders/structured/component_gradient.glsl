// The gradient of an independent component at a depth in the cell.
vec3 gradientOfComponent(int component, CellInterval cell, real depth)
{
  return gradientFromLattice(latticeGradientOf(component, cell.crossed, cell.ray.start + cell.ray.slope * depth));
}
