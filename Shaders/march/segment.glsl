// A segment is a part of a ray along which the scalar is linear in the depth, or bent but monotonic. A tetrahedron with
// scalars at its vertices yields one linear segment; so does a cell with a constant scalar.
//
// Only these functions rely on the linearity:
//   scalarAt                          the scalar at a depth                       march/linear_scalar.glsl
//   extraAt                         an extra scalar at a depth                 march/cell_interval.glsl
//   isTransparentBetween              no scalar is beyond those at the ends       tables/integral_table.glsl
//   extremeScalar                     the extremes are at the ends                below
//   crossesSurface, fractionOfValue   a value is crossed once at most             below
//   meanOver, meanBetween             a mean over the depth is one over scalars   tables/integral_table.glsl
//   countedFraction                   scalars in a range are one interval         gather/sum.glsl
//   subsegmentError                   the colour varies as the table does         gather/..._component(s).glsl
// A trilinear cell that is cut evenly is one segment (gather/segment_even.glsl). In other trilinear cells the scalar is
// a cubic: segments end at its extremes, so that extremes and crossings are right; the scalar at a depth is that of the
// cubic; subsegments end at scalars of the cubic, and the effect of the bend between them on the colour is an
// additional term of subsegmentError (structured/bend.glsl).

struct Segment
{
  vec2 begin; // depth and scalar
  vec2 end;
#if TETMARCH_BENT
  vec2 bend;  // structured/bend.glsl
#endif
#if TETMARCH_COMPONENTS
  vec3 extraBegin; // extra scalars
#if TETMARCH_POINT_SCALARS
  vec3 extraEnd;
#endif
#if TETMARCH_BENT
  ExtraBend extraBend; // structured/extra_cubics.glsl
#endif
#endif
};

#if TETMARCH_EXTREME
// The maximum of sign times the scalar of a segment; with the sign -1 it belongs to the minimum.
real extremeScalar(Segment segment, real sign) { return max(sign * segment.begin.y, sign * segment.end.y); }
#endif

#if TETMARCH_ISOSURFACES
// The number of isosurface values that the scalar has reached.
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
// The position, 0..1, in the segment at which its scalar has a value. Cell scalars change at the begin of a segment.
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
