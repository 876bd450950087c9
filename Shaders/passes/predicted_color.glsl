// The colour halfway between the second and the third of four samples in a row, by the cubic polynomial through them
// (Deslauriers and Dubuc 1989, "Symmetric iterative interpolation processes").
vec4 colorAmongFour(vec4 first, vec4 second, vec4 third, vec4 fourth)
{
  return 0.5625 * (second + third) - 0.0625 * (first + fourth);
}
