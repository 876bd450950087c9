// Clipping planes leave a convex region, so that of a ray they leave one range of depths.

// The part of a range of depths that all planes leave; if it does not end behind its begin, they leave nothing.
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
    // Of a ray along the plane all or nothing is left.
    real outside = height >= real(0) ? -NO_DEPTH : NO_DEPTH;
    real begin = crosses ? (slope > real(0) ? depth : -NO_DEPTH) : outside;
    real end = crosses && slope < real(0) ? depth : NO_DEPTH;
    range = vec2(max(range.x, begin), min(range.y, end));
  }
  return range;
}
