// Dependent components: the colour comes from other scalars than the extinction. Of four these are red, green and
// blue, of two it is one, by a table of colours behind that of the opacity.

#if TETMARCH_POINT_SCALARS
// Of a piece in which the scalars are linear.
struct DependentColor
{
  vec3 color; // mean over the length
#if TETMARCH_ERROR_BOUND
  real change; // total variation of the channel that changes most
#endif
};

DependentColor dependentColorBetween(vec3 from, vec3 to)
{
  DependentColor tint;
#if TETMARCH_DIRECT_COLOR
  tint.color = (from + to) * real(0.5);
#if TETMARCH_ERROR_BOUND
  vec3 rise = to - from;
  tint.change = max(abs(rise.x), max(abs(rise.y), abs(rise.z)));
#endif
#else
  TableSpan table = tableSpan(1);
  TablePoint p = tablePoint(table, from.x * table.scale + table.offset);
  TablePoint q = tablePoint(table, to.x * table.scale + table.offset);
  vec4 mean = meanBetween(table, p, q); // the extinction in it is 1
  tint.color = vec3(mean.x, mean.y, mean.z);
#if TETMARCH_ERROR_BOUND
  tint.change = min(abs(q.variation - p.variation), real(1));
#endif
#endif
  return tint;
}

vec4 withDependentColor(vec4 mean, DependentColor tint)
{
  return vec4(tint.color.x * mean.w, tint.color.y * mean.w, tint.color.z * mean.w, mean.w);
}

#if TETMARCH_ERROR_BOUND
// What a piece loses whose means of C and tau are taken apart, between two points of the table of the opacity;
// extinction is their mean. The mean of C tau over that of tau differs from the mean of C by the covariance of both
// over the mean of tau: at most a quarter of the product of their ranges (Gruess 1935). To that comes the order of
// colours (gather/order_error.glsl). And what is sent out has a mean of the piece's colours, as the exact one has, so that
// both together are no more than the variation of the colour times what is absorbed.
real dependentError(DependentColor tint, TablePoint p, TablePoint q, real extinction, Absorption piece)
{
  real spread = abs(q.extinctionVariation - p.extinctionVariation);
  real apart = piece.absorbed * real(0.25) * spread / max(extinction, TINY);
  return tint.change * min(piece.absorbed, orderErrorFactor(piece.depth) + apart);
}
#endif
#else
// Where the scalars are constant.
vec3 dependentColorOf(vec3 further)
{
#if TETMARCH_DIRECT_COLOR
  return further;
#else
  TableSpan table = tableSpan(1);
  vec4 value = tableValue(table, further.x * table.scale + table.offset);
  return vec3(value.x, value.y, value.z);
#endif
}

vec4 withDependentColor(vec4 value, vec3 color)
{
  return vec4(color.x * value.w, color.y * value.w, color.z * value.w, value.w);
}
#endif
