// Clipping planes: what they leave is convex, so that of a ray it is what lies between two depths.

// Of a range of depths, what is left by all planes; nothing, if it doesn't end behind its begin.
vec2 clippedRange(Ray ray, vec2 range)
{
  for (int i = 0; i < clippingPlaneCount; ++i)
  {
    vec4 plane = fetchClippingPlane(i);
    vec3 normal = vec3(plane.x, plane.y, plane.z);
    real slope = dot(normal, ray.direction);
    real height = dot(normal, ray.origin) + plane.w; // of the ray's origin above the plane
    bool crosses = abs(slope) > TINY;
    real depth = -height / (crosses ? slope : real(1));
    // Along the plane, all or nothing is left.
    real outside = height >= real(0) ? -NO_DEPTH : NO_DEPTH;
    real begin = crosses ? (slope > real(0) ? depth : -NO_DEPTH) : outside;
    real end = crosses && slope < real(0) ? depth : NO_DEPTH;
    range = vec2(max(range.x, begin), min(range.y, end));
  }
  return range;
}
