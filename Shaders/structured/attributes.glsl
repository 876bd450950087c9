// What a point of the ray carries beside its scalar.

struct VertexAttributes
{
  vec3 gradient; // of the scalar, in the normalised frame
#if TETMARCH_VERTEX_LIGHT
  vec4 light;    // transmittance towards ambient light and towards up to three lights that cast shadows
#endif
};

#if TETMARCH_POINT_SCALARS
// Between two places along x and y, of four values in the order of fetchValues().
real bilinear(vec4 values, vec3 place)
{
  real south = values.w + (values.z - values.w) * place.x;
  real north = values.x + (values.y - values.x) * place.x;
  return south + (north - south) * place.y;
}
#endif

#if !TETMARCH_POINT_SCALARS
// Half of the difference between the values on both sides, in lattice coordinates; at the end of an axis that of one side
// and the cell's own. Planes are taken for evenly spaced.
vec3 latticeGradientAt(ivec3 cell, vec3 place)
{
  int i = cell.x + firstValue.x;
  int j = cell.y + firstValue.y;
  int k = cell.z + firstValue.z;
  vec3 high = vec3(fetchValue(i + 1, j, k), fetchValue(i, j + 1, k), fetchValue(i, j, k + 1));
  vec3 low = vec3(fetchValue(i - 1, j, k), fetchValue(i, j - 1, k), fetchValue(i, j, k - 1));
  return (high - low) * real(0.5);
}
#elif TETMARCH_CELL_GRADIENTS
// The gradient of the trilinear cell itself, in lattice coordinates.
vec3 latticeGradientAt(ivec3 cell, vec3 place)
{
  int i = cell.x + firstValue.x;
  int j = cell.y + firstValue.y;
  int k = cell.z + firstValue.z;
  vec4 low = fetchValues(i, j, k);
  vec4 high = fetchValues(i, j, k + 1);
  CellFrame frame = cellFrame(cell);
  vec3 a = (place - frame.begin) * frame.perWidth;
  vec4 between = low + (high - low) * a.z;
  real dx = between.z - between.w + (between.y - between.x - (between.z - between.w)) * a.y;
  real dy = between.x - between.w + (between.y - between.z - (between.x - between.w)) * a.x;
  return vec3(dx, dy, bilinear(high - low, a)) * frame.perWidth;
}
#else
// 1 over the distance between the neighbours of a value along an axis. At the end of the axis the value itself is one of
// them.
#if TETMARCH_RECTILINEAR
real perDistance(int value, int axisLast, int plane, int axisFirst)
{
  real low = fetchPlane(plane + clamp(value - 1, 0, axisLast) - axisFirst);
  real high = fetchPlane(plane + clamp(value + 1, 0, axisLast) - axisFirst);
  return real(1) / max(high - low, TINY);
}
#else
real perDistance(int value, int axisLast, int plane, int axisFirst)
{
  return value <= 0 || value >= axisLast ? real(1) : real(0.5);
}
#endif

// Of the values at both ends of a cell.
vec2 perDistances(int value, int axisLast, int plane, int axisFirst)
{
  return vec2(perDistance(value, axisLast, plane, axisFirst), perDistance(value + 1, axisLast, plane, axisFirst));
}

// The cell itself or, for the half cells at the ends of an axis, that between the values beside it. There the gradient is
// that at the outermost values, as the scalar is.
int innerCell(int cell, int axisFirst, int axisLast) { return max(min(cell, axisLast - 1 - axisFirst), -axisFirst); }

// In lattice coordinates: central differences at the corners of the cell (Hoehne and Bernstein, "Shading 3D-images from CT
// using gray-level gradients", 1986), trilinear between them. The values are those of two layers of 4 x 4 around the cell,
// without their corners, and 2 x 2 below and above them.
vec3 latticeGradientAt(ivec3 cell, vec3 place)
{
  ivec3 inner = ivec3(innerCell(cell.x, firstValue.x, lastValue.x), innerCell(cell.y, firstValue.y, lastValue.y),
    innerCell(cell.z, firstValue.z, lastValue.z));
  int i = inner.x + firstValue.x;
  int j = inner.y + firstValue.y;
  int k = inner.z + firstValue.z;
  CellFrame frame = cellFrame(inner);
  vec3 at = (place - frame.begin) * frame.perWidth;
  vec3 a = vec3(clamp(at.x, real(0), real(1)), clamp(at.y, real(0), real(1)), clamp(at.z, real(0), real(1)));
  vec4 low = fetchValues(i, j, k);
  vec4 high = fetchValues(i, j, k + 1);
  vec4 below = fetchValues(i, j, k - 1);
  vec4 above = fetchValues(i, j, k + 2);
  // What differs between the layers is linear between them.
  vec4 mid = low + (high - low) * a.z;
  vec4 lowWest = fetchValues(i - 1, j, k);
  vec4 west = lowWest + (fetchValues(i - 1, j, k + 1) - lowWest) * a.z;
  vec4 lowEast = fetchValues(i + 1, j, k);
  vec4 east = lowEast + (fetchValues(i + 1, j, k + 1) - lowEast) * a.z;
  vec4 lowSouth = fetchValues(i, j - 1, k);
  vec4 south = lowSouth + (fetchValues(i, j - 1, k + 1) - lowSouth) * a.z;
  vec4 lowNorth = fetchValues(i, j + 1, k);
  vec4 north = lowNorth + (fetchValues(i, j + 1, k + 1) - lowNorth) * a.z;
  vec2 perX = perDistances(i, lastValue.x, firstPlane.x, firstValue.x);
  vec2 perY = perDistances(j, lastValue.y, firstPlane.y, firstValue.y);
  vec2 perZ = perDistances(k, lastValue.z, firstPlane.z, firstValue.z);
  // At the four corners, in the order of fetchValues().
  vec4 dx = vec4((mid.y - west.x) * perX.x, (east.y - mid.x) * perX.y, (east.z - mid.w) * perX.y, (mid.z - west.w) * perX.x);
  vec4 dy =
    vec4((north.x - mid.w) * perY.y, (north.y - mid.z) * perY.y, (mid.y - south.z) * perY.x, (mid.x - south.w) * perY.x);
  vec4 lowZ = (high - below) * perZ.x;
  vec4 dz = lowZ + ((above - low) * perZ.y - lowZ) * a.z;
  return vec3(bilinear(dx, a), bilinear(dy, a), bilinear(dz, a));
}
#endif

VertexAttributes attributesAt(Ray ray, ivec3 cell, real depth)
{
  VertexAttributes attributes;
  attributes.gradient = gradientFromLattice(latticeGradientAt(cell, ray.start + ray.slope * depth));
#if TETMARCH_VERTEX_LIGHT
  attributes.light = vec4(real(1), real(1), real(1), real(1));
#endif
  return attributes;
}
