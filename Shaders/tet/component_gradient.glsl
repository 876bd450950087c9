// The gradient of an independent component at a depth in the tetrahedron: between those where the ray enters and leaves.
vec3 gradientOfComponent(int component, CellInterval cell, real depth)
{
  vec3 gradient = componentGradient(cell.enterAttributes, component);
  return gradient +
    (componentGradient(cell.leaveAttributes, component) - gradient) * fractionAt(cell.enter, cell.leave, depth);
}
