// Between two points of a ray within a cell the scalar is linear in the depth; march/segment.glsl lists the
// consequences.

// The fraction 0..1 of a depth between two points (depth, scalar) of a ray.
real fractionAt(vec2 first, vec2 second, real depth) { return (depth - first.x) / (second.x - first.x); }

// Scalar at a depth between two points (depth, scalar).
real scalarAt(vec2 first, vec2 second, real depth)
{
  return first.y + (second.y - first.y) * fractionAt(first, second, depth);
}
