// Where a ray is picked: the point up to which it has gathered an opacity, and the tetrahedron around that. The march of
// extinction ends in it if the transmittance that is left there takes the place of its tolerance.

CONSTANT int PICK_STEPS = 32; // halvings of the way through a tetrahedron

struct Pick
{
  bool hit;
  uint tet;
  real depth;  // along the ray
  real scalar; // as it is stored, also if it is not finite
};

// The tetrahedron that a ray has left by a face, whose link says what lies behind.
Tet tetBefore(Crossing face, uvec2 link)
{
  uint rank = (link.y > face.id.x ? 1u : 0u) + (link.y > face.id.y ? 1u : 0u) + (link.y > face.id.z ? 1u : 0u);
  bool outside = link.x >= LINK_OUTSIDE;
  uvec2 back = fetchLink(outside ? 4u * tetCount + (link.x - LINK_OUTSIDE) : 4u * link.x + rank);
  Tet tet;
  tet.number = back.x;
  tet.a = face.id.x;
  tet.b = face.id.z;
  tet.c = face.id.y;
  tet.d = back.y;
  return tet;
}

// A ray's way through a tetrahedron.
struct Transit
{
  uint tet;
  vec2 enter; // depth and scalar
  vec2 leave;
#if TETMARCH_GRADIENT_OPACITY && TETMARCH_VERTEX_GRADIENTS
  real densityEnter;
  real densityLeave;
#endif
#if TETMARCH_INDEPENDENT && TETMARCH_POINT_SCALARS
  vec3 furtherEnter; // scalars beside the first
  vec3 furtherLeave;
#endif
};

// Between two depths on it.
real opticalDepthOn(Transit way, vec2 range, real opticalLength)
{
#if TETMARCH_INDEPENDENT && TETMARCH_POINT_SCALARS
  real extinction = extinctionBetween(way.enter, way.leave, way.furtherEnter, way.furtherLeave, range);
#elif TETMARCH_POINT_SCALARS
  TablePoint at = tablePoint(tableOffset);
  real extinction = extinctionBetween(way.enter, way.leave, range, at);
#else
  real extinction = extinctionOf(way.tet);
#endif
#if TETMARCH_GRADIENT_OPACITY && TETMARCH_VERTEX_GRADIENTS
  extinction = extinction * densityBetween(way.enter, way.leave, range, way.densityEnter, way.densityLeave);
#elif TETMARCH_GRADIENT_OPACITY
  extinction = extinction * gradientOpacity(fetchCellGradient(way.tet));
#endif
  extinction = countedExtinction(extinction, way.tet, way.enter, way.leave);
  return extinction * (range.y - range.x) * opticalLength;
}

// The way of a ray that has left a tetrahedron by a face; of no length if rounding hides how it came in.
Transit transitOf(Ray ray, Tet tet, Crossing exit)
{
  Transit way;
  way.tet = tet.number;
  way.leave = crossingPoint(exit);
  Crossing entry;
  uvec2 link;
  bool entered = entersTet(ray, tet, entry, link);
  vec2 enter = crossingPoint(entry);
  way.enter = entered ? enter : way.leave;
#if TETMARCH_GRADIENT_OPACITY && TETMARCH_VERTEX_GRADIENTS
  fetchCorners(entry);
  way.densityLeave = densityAt(exit);
  way.densityEnter = entered ? densityAt(entry) : way.densityLeave;
#endif
#if TETMARCH_INDEPENDENT && TETMARCH_POINT_SCALARS
  fetchCorners(entry);
  way.furtherLeave = furtherAt(exit);
  way.furtherEnter = entered ? furtherAt(entry) : way.furtherLeave;
#endif
  return way;
}

// Between two depths, by the opacity 1 - errorTolerance.
Pick pickOn(Ray ray, real opticalLength, real depthBegin, real depthEnd, INOUT(Way) way)
{
  Attenuation passed = attenuate(ray, opticalLength, depthBegin, depthEnd, way);
  real excess = passed.depth + log(errorTolerance); // optical depth between the point and the march's end
  Pick pick;
  pick.hit = excess > real(0);
  pick.tet = 0u;
  pick.depth = passed.done;
  pick.scalar = real(0);
  if (pick.hit)
  {
    Transit transit = transitOf(ray, tetBefore(way.face, way.link), way.face);
    real low = min(transit.enter.x, passed.done);
    real high = passed.done;
    for (int i = 0; i < PICK_STEPS; ++i)
    {
      real middle = low + (high - low) * real(0.5);
      bool before = opticalDepthOn(transit, vec2(middle, passed.done), opticalLength) > excess;
      low = before ? middle : low;
      high = before ? high : middle;
    }
    pick.tet = transit.tet;
    pick.depth = max(high, depthBegin);
#if TETMARCH_POINT_SCALARS
    pick.scalar = transit.leave.x > transit.enter.x ? scalarAt(transit.enter, transit.leave, pick.depth) : transit.leave.y;
#else
    pick.scalar = fetchCellScalar(transit.tet);
#endif
#if TETMARCH_NAN_SHOWN
    pick.scalar = isFinite(transit.tet, transit.enter, transit.leave) ? pick.scalar : UNDRAWN_SCALAR;
#endif
  }
  return pick;
}
