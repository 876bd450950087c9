// The maximum or minimum scalar along the ray (blend modes maximum and minimum; Wallis, Miller, Lerner and Kleerup,
// "Three-dimensional display in nuclear medicine", 1989).

// The state of a ray.
struct Radiance
{
  real extreme; // scalar times extremeSign
};

Radiance noRadiance()
{
  Radiance radiance;
  radiance.extreme = -NO_DEPTH;
  return radiance;
}

#if TETMARCH_PICKED
real gathered(Radiance radiance) { return radiance.extreme; }
#endif

// Any cell behind may have a more extreme scalar.
bool isOpaque(Radiance radiance) { return false; }

real errorBound(Radiance radiance) { return real(0); }

// Premultiplied colour and opacity of the extreme scalar. They do not depend on lengths.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  vec4 value = tableValue(extremeSign * radiance.extreme * tableScale + tableOffset);
  real opacity = radiance.extreme > -NO_DEPTH ? value.w : real(0);
  return vec4(value.x * opacity, value.y * opacity, value.z * opacity, opacity);
}

int gatherSegment(Segment segment, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  radiance.extreme = max(radiance.extreme, extremeScalar(segment, extremeSign));
  return 1;
}
