// A segment is a part of a ray along which the scalar is linear in the depth, or bends but rises or falls. A tetrahedron
// with scalars at its vertices yields one linear segment; so does a cell with a scalar of its own, which is constant in it.
//
// Whatever a ray gathers relies on that linearity, and only in these places:
//   scalarAt                          the scalar at a depth                       march/linear_scalar.glsl
//   furtherAt                         a further scalar at a depth                 march/cell_interval.glsl
//   isTransparentBetween              no scalar is beyond those at the ends       tables/integral_table.glsl
//   extremeScalar                     the extremes are at the ends                below
//   crossesSurface, fractionOfValue   a value is crossed once at most             below
//   meanBetween                       a mean over the depth is one over scalars   tables/integral_table.glsl
//   countedFraction                   scalars in a range are one interval         gather/sum.glsl
//   subsegmentError                   the colour varies as the table does         gather/..._component(s).glsl
// A trilinear cell that is cut evenly is one segment (gather/segment_even.glsl). Others make the scalar a cubic, too: their
// segments end where that has an extreme, so that extremes and crossings are
// right; the scalar at a depth is that of the cubic; subsegments end at scalars of the cubic, and what the bend between
// them changes of the colour is one more term of subsegmentError (structured/bend.glsl).

struct Segment
{
  vec2 begin; // depth and scalar
  vec2 end;
#if TETMARCH_BENT
  vec2 bend;  // structured/bend.glsl
#endif
#if TETMARCH_COMPONENTS
  vec3 furtherBegin; // scalars beside the first
#if TETMARCH_POINT_SCALARS
  vec3 furtherEnd;
#endif
#if TETMARCH_BENT
  FurtherBend furtherBend; // structured/further_cubics.glsl
#endif
#endif
};

#if TETMARCH_EXTREME
// The greatest scalar of a segment, times the sign; with the sign -1 that is the least one.
real extremeScalar(Segment segment, real sign) { return max(sign * segment.begin.y, sign * segment.end.y); }
#endif

#if TETMARCH_ISOSURFACES
// How many of the values of the surfaces the scalar has reached.
int valuesReached(real scalar)
{
  int reached = 0;
  for (int i = 0; i < isoSurfaceCount; ++i)
  {
    reached = reached + (scalar >= fetchIsoValue(i) ? 1 : 0);
  }
  return reached;
}

bool crossesSurface(Segment segment) { return valuesReached(segment.begin.y) != valuesReached(segment.end.y); }

#if TETMARCH_LIT
// How far in the segment its scalar has a value, 0..1. Scalars of cells change where a segment begins.
real fractionOfValue(Segment segment, real value)
{
#if TETMARCH_POINT_SCALARS
  return clamp((value - segment.begin.y) / (segment.end.y - segment.begin.y), real(0), real(1));
#else
  return real(0);
#endif
}
#endif
#endif
