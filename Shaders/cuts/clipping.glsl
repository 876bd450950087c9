// Clipping planes bound a convex region, so that one range of depths of a ray remains.

// The part of a range of depths that remains after all planes; if it does not end behind its begin, nothing remains.
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
    // All or nothing of a ray parallel to the plane remains.
    real outside = height >= real(0) ? -NO_DEPTH : NO_DEPTH;
    real begin = crosses ? (slope > real(0) ? depth : -NO_DEPTH) : outside;
    real end = crosses && slope < real(0) ? depth : NO_DEPTH;
    range = vec2(max(range.x, begin), min(range.y, end));
  }
  return range;
}
