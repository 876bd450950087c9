// Attributes of a point of the ray besides its scalar.

struct VertexAttributes
{
  vec3 gradient; // of the scalar, in the normalised frame
#if TETMARCH_VERTEX_LIGHT
  vec4 light;    // transmittance towards ambient light and towards up to three lights that cast shadows
#endif
};

#if !TETMARCH_CELL_GRADIENTS
// The value, or another one if it is not finite.
real finiteOr(real value, real otherwise) { return isDrawn(value) ? value : otherwise; }
#endif

#if TETMARCH_POINT_SCALARS
// Interpolation along x and y between four values in the order of fetchValues().
real bilinear(vec4 values, vec3 place)
{
  real south = values.w + (values.z - values.w) * place.x;
  real north = values.x + (values.y - values.x) * place.x;
  return south + (north - south) * place.y;
}
#else
#if TETMARCH_LEAF_CELLS
// The scalar beside a leaf, and its distance from the middle of the leaf. A neighbour is the leaf at the given cell; what
// is hidden, not finite or beyond the lattice has the leaf's own scalar.
vec2 scalarBeside(int component, Leaf leaf, real own, ivec3 cell, bool inside)
{
  Leaf beside = leafAround(inside ? cell : leaf.low);
  ivec3 value = valueOfLeaf(beside);
  real scalar = finiteOr(fetchValueOf(component, value.x, value.y, value.z), own);
#if TETMARCH_HIDDEN_CELLS
  inside = inside && !(hasOctree() && isHidden(beside.number));
#endif
  return vec2(inside ? scalar : own, real(0.5) * real(leaf.width + beside.width));
}

real slopeBetween(vec2 low, vec2 high) { return (high.x - low.x) / (low.y + high.y); }

// The difference between the scalars on both sides over their distance, in lattice coordinates. Planes are assumed to be
// evenly spaced.
vec3 latticeGradientOf(int component, ivec3 cell, vec3 place)
{
  Leaf leaf = leafAround(cell);
  ivec3 value = valueOfLeaf(leaf);
  real own = fetchValueOf(component, value.x, value.y, value.z);
  ivec3 below = ivec3(leaf.low.x - 1, leaf.low.y - 1, leaf.low.z - 1);
  ivec3 above = ivec3(leaf.low.x + leaf.width, leaf.low.y + leaf.width, leaf.low.z + leaf.width);
  // In the middle of the leaf's faces.
  ivec3 middle = ivec3(leaf.low.x + leaf.width / 2, leaf.low.y + leaf.width / 2, leaf.low.z + leaf.width / 2);
  return vec3(
    slopeBetween(scalarBeside(component, leaf, own, ivec3(below.x, middle.y, middle.z), below.x >= 0),
      scalarBeside(component, leaf, own, ivec3(above.x, middle.y, middle.z), above.x < latticeCells.x)),
    slopeBetween(scalarBeside(component, leaf, own, ivec3(middle.x, below.y, middle.z), below.y >= 0),
      scalarBeside(component, leaf, own, ivec3(middle.x, above.y, middle.z), above.y < latticeCells.y)),
    slopeBetween(scalarBeside(component, leaf, own, ivec3(middle.x, middle.y, below.z), below.z >= 0),
      scalarBeside(component, leaf, own, ivec3(middle.x, middle.y, above.z), above.z < latticeCells.z)));
}
#else
// Half of the difference between the values on both sides, in lattice coordinates; at the end of an axis, between one
// side and the cell's own value. Planes are assumed to be evenly spaced.
vec3 latticeGradientOf(int component, ivec3 cell, vec3 place)
{
  int i = cell.x + firstValue.x;
  int j = cell.y + firstValue.y;
  int k = cell.z + firstValue.z;
  real own = fetchValueOf(component, i, j, k);
  vec3 high = vec3(finiteOr(fetchValueOf(component, i + 1, j, k), own), finiteOr(fetchValueOf(component, i, j + 1, k), own),
    finiteOr(fetchValueOf(component, i, j, k + 1), own));
  vec3 low = vec3(finiteOr(fetchValueOf(component, i - 1, j, k), own), finiteOr(fetchValueOf(component, i, j - 1, k), own),
    finiteOr(fetchValueOf(component, i, j, k - 1), own));
  return (high - low) * real(0.5);
}
#endif
#endif

#if TETMARCH_CELL_GRADIENTS
// The gradient of the trilinear cell itself, in lattice coordinates.
vec3 latticeGradientOf(int component, ivec3 cell, vec3 place)
{
  int i = cell.x + firstValue.x;
  int j = cell.y + firstValue.y;
  int k = cell.z + firstValue.z;
  vec4 low = fetchValuesOf(component, i, j, k);
  vec4 high = fetchValuesOf(component, i, j, k + 1);
  CellFrame frame = cellFrame(cell);
  vec3 a = (place - frame.begin) * frame.perWidth;
  vec4 between = low + (high - low) * a.z;
  real dx = between.z - between.w + (between.y - between.x - (between.z - between.w)) * a.y;
  real dy = between.x - between.w + (between.y - between.z - (between.x - between.w)) * a.x;
  return vec3(dx, dy, bilinear(high - low, a)) * frame.perWidth;
}
#elif TETMARCH_POINT_SCALARS
// Reciprocal of the distance between the neighbours of a value along each axis. At the end of an axis the value itself
// is one of them.
vec3 perDistances(ivec3 value)
{
  ivec3 low = ivec3(clamp(value.x - 1, 0, lastValue.x), clamp(value.y - 1, 0, lastValue.y),
    clamp(value.z - 1, 0, lastValue.z));
  ivec3 high = ivec3(clamp(value.x + 1, 0, lastValue.x), clamp(value.y + 1, 0, lastValue.y),
    clamp(value.z + 1, 0, lastValue.z));
  vec3 d = planesAt(high - firstValue) - planesAt(low - firstValue);
  return vec3(real(1) / max(d.x, TINY), real(1) / max(d.y, TINY), real(1) / max(d.z, TINY));
}

// Neighbours of the given values, which replace those that are not finite.
vec4 fetchBeside(int component, int i, int j, int k, vec4 own)
{
  vec4 values = fetchValuesOf(component, i, j, k);
  return vec4(finiteOr(values.x, own.x), finiteOr(values.y, own.y), finiteOr(values.z, own.z),
    finiteOr(values.w, own.w));
}

// The cell itself or, for the half cells at the ends of an axis, the adjacent one between values. There the gradient is
// that at the outermost values, like the scalar.
int innerCell(int cell, int axisFirst, int axisLast) { return max(min(cell, axisLast - 1 - axisFirst), -axisFirst); }

// In lattice coordinates: central differences at the corners of the cell (Hoehne and Bernstein, "Shading 3D-images from CT
// using gray-level gradients", 1986), trilinear between them. The values are those of two layers of 4 x 4 around the cell,
// without their corners, and 2 x 2 below and above them.
vec3 latticeGradientOf(int component, ivec3 cell, vec3 place)
{
  ivec3 inner = ivec3(innerCell(cell.x, firstValue.x, lastValue.x), innerCell(cell.y, firstValue.y, lastValue.y),
    innerCell(cell.z, firstValue.z, lastValue.z));
  int i = inner.x + firstValue.x;
  int j = inner.y + firstValue.y;
  int k = inner.z + firstValue.z;
  CellFrame frame = cellFrame(inner);
  vec3 at = (place - frame.begin) * frame.perWidth;
  vec3 a = vec3(clamp(at.x, real(0), real(1)), clamp(at.y, real(0), real(1)), clamp(at.z, real(0), real(1)));
  vec4 low = fetchValuesOf(component, i, j, k);
  vec4 high = fetchValuesOf(component, i, j, k + 1);
  vec4 below = fetchBeside(component, i, j, k - 1, low);
  vec4 above = fetchBeside(component, i, j, k + 2, high);
  // Quantities that differ between the layers are linear between them.
  vec4 mid = low + (high - low) * a.z;
  vec4 lowWest = fetchBeside(component, i - 1, j, k, low);
  vec4 west = lowWest + (fetchBeside(component, i - 1, j, k + 1, high) - lowWest) * a.z;
  vec4 lowEast = fetchBeside(component, i + 1, j, k, low);
  vec4 east = lowEast + (fetchBeside(component, i + 1, j, k + 1, high) - lowEast) * a.z;
  vec4 lowSouth = fetchBeside(component, i, j - 1, k, low);
  vec4 south = lowSouth + (fetchBeside(component, i, j - 1, k + 1, high) - lowSouth) * a.z;
  vec4 lowNorth = fetchBeside(component, i, j + 1, k, low);
  vec4 north = lowNorth + (fetchBeside(component, i, j + 1, k + 1, high) - lowNorth) * a.z;
  vec3 perLow = perDistances(ivec3(i, j, k));
  vec3 perHigh = perDistances(ivec3(i + 1, j + 1, k + 1));
  // At the four corners, in the order of fetchValues().
  vec4 dx = vec4((mid.y - west.x) * perLow.x, (east.y - mid.x) * perHigh.x, (east.z - mid.w) * perHigh.x,
    (mid.z - west.w) * perLow.x);
  vec4 dy = vec4((north.x - mid.w) * perHigh.y, (north.y - mid.z) * perHigh.y, (mid.y - south.z) * perLow.y,
    (mid.x - south.w) * perLow.y);
  vec4 lowZ = (high - below) * perLow.z;
  vec4 dz = lowZ + ((above - low) * perHigh.z - lowZ) * a.z;
  return vec3(bilinear(dx, a), bilinear(dy, a), bilinear(dz, a));
}
#endif

vec3 gradientAt(Ray ray, ivec3 cell, real depth)
{
  return gradientFromLattice(latticeGradientOf(0, cell, ray.start + ray.slope * depth));
}

VertexAttributes attributesWith(vec3 gradient, Ray ray, real depth)
{
  VertexAttributes attributes;
  attributes.gradient = gradient;
#if TETMARCH_VERTEX_LIGHT
  attributes.light = keptLightAt(ray.start + ray.slope * depth);
#endif
  return attributes;
}

VertexAttributes attributesAt(Ray ray, ivec3 cell, real depth)
{
  return attributesWith(gradientAt(ray, cell, depth), ray, depth);
}
