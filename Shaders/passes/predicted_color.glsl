// A colour halfway between samples, predicted from two or four of them in a row. The four are those of the cubic
// polynomial through them (Deslauriers and Dubuc 1989, "Symmetric iterative interpolation processes").
vec4 colorBetween(vec4 before, vec4 after) { return 0.5 * (before + after); }

vec4 colorAmongFour(vec4 farBefore, vec4 before, vec4 after, vec4 farAfter)
{
  return 0.5625 * (before + after) - 0.0625 * (farBefore + farAfter);
}
