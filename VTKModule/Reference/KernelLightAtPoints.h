// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of every point of a cell, as members of a kernel; part of KernelBody.h. The shaders
// evaluate light at both ends of a cell. Here the interval is halved until the result stands still
// (adaptive quadrature; Gander and Gautschi, 2000). The error is an estimate, not a bound: a shadow
// may fall between all points of a ray. Points are an eighth of a cell or 1/128 of opacity apart.

bool LightAtPoints = false; // else as in the shaders
Real lightTolerance = 0;
Ray LitRay{}; // crosses the interval

struct LitPoint
{
  Real Depth;
  Shade Shaded;
};

// The ends of an interval are on faces. If a face of the boundary is in the plane of a light, its
// points are both lit and shadowed. So light is evaluated this fraction of the interval inside.
static constexpr double Inset = 1.0 / 8192;
static constexpr int LeastHalvings = TETMARCH_SHADING ? 3 : 1;
static constexpr int MostHalvings = 48;

template <typename Scene>
void useLightAtPoints(const Scene& scene)
{
  // Rays towards a light have an exact transmittance elsewhere.
  const bool changes = TETMARCH_SHADING || TETMARCH_BENT || !Effects->GradientOpacity.empty();
  LightAtPoints = scene.Light == LightAt::Points && changes;
}

// At the end of a cell. Returns whether gatherLit() evaluates its light.
bool shadesPoints(const Ray& ray, CellInterval& cell)
{
  if (LightAtPoints)
  {
    LitRay = ray;
#if TETMARCH_VERTEX_LIGHT_ERROR
    cell.interpolationError = 0;
#endif
  }
  return LightAtPoints;
}

Shade shadeWithin(const CellInterval& cell, Real depth)
{
#if !TETMARCH_SHADING
  if (Effects->GradientOpacity.empty())
  {
    return { 1 };
  }
#endif
  const FacePoint point = pointWithin(LitRay, cell, depth);
#if TETMARCH_VERTEX_GRADIENTS
  return shadeAtFace(LitRay, point);
#else
  return shadeOf(
    LitRay, depth, point.scalar, fetchCellGradient(cell.number), incomingAt(LitRay, point));
#endif
}

// Gathers a part of the cell with the mean of two shades.
int gatherPart(Real thicknessPerDepth, vec2 part, const Shade& a, const Shade& b, CellInterval cell,
  Radiance& radiance)
{
  cell.begin = part.x;
  cell.end = part.y;
  cell.enterShade = a;
#if TETMARCH_GRADIENT_OPACITY
  cell.enterShade.density = (a.density + b.density) / 2;
#endif
#if TETMARCH_LIT
  cell.enterShade.lit = mixIllumination(a.lit, b.lit, Real(0.5));
#endif
  cell.leaveShade = cell.enterShade;
  return gatherCell(thicknessPerDepth, cell, radiance);
}

// The greatest difference of the transmittance or of a channel.
Real differenceOf(const Radiance& a, const Radiance& b)
{
  Real difference = abs(a.transmittance - b.transmittance);
#if TETMARCH_LIT
  const vec3 colors = a.color - b.color;
  difference = max(difference, max(abs(colors.x), max(abs(colors.y), abs(colors.z))));
#endif
  return difference;
}

// Whether the error fits the tolerance in proportion to the absorption; only then if the part is
// short or absorbs little, so that narrow shadows in it matter less. Where light jumps, no part is
// short enough; such parts end when they absorb almost nothing.
bool isSettled(Real error, Real absorbed, int halvings)
{
  const bool fine = halvings >= LeastHalvings || absorbed <= Real(1.0 / 64);
  return absorbed <= lightTolerance / 16 || halvings >= MostHalvings ||
         (fine && !(error > lightTolerance * absorbed));
}

// The errors of a part and of its halves are of second order; this combination of both is of fourth
// order (Richardson, 1911).
static Radiance extrapolated(const Radiance& whole, Radiance halves, Real error)
{
  halves.color = halves.color + (halves.color - whole.color) * Real(1.0 / 3);
  halves.transmittance =
    max(halves.transmittance + (halves.transmittance - whole.transmittance) / 3, Real(0));
#if TETMARCH_LIGHT_ERROR
  halves.lightError = halves.lightError + error;
#endif
  return halves;
}

// Returns the number of lookups. Three rules on the same points must agree: the mean of the ends,
// the middle, and the means of both halves. Two alone agree by chance on a sheet within one half.
int gatherBetween(Real thicknessPerDepth, const LitPoint& from, const LitPoint& to, int halvings,
  const CellInterval& cell, Radiance& radiance)
{
  const Real depth = (from.Depth + to.Depth) / 2;
  const LitPoint middle{ depth, shadeWithin(cell, depth) };
  const vec2 all{ from.Depth, to.Depth };
  Radiance whole = radiance;
  Radiance even = radiance;
  Radiance halves = radiance;
  gatherPart(thicknessPerDepth, all, from.Shaded, to.Shaded, cell, whole);
  gatherPart(thicknessPerDepth, all, middle.Shaded, middle.Shaded, cell, even);
  int lookups =
    gatherPart(thicknessPerDepth, { all.x, depth }, from.Shaded, middle.Shaded, cell, halves);
  lookups +=
    gatherPart(thicknessPerDepth, { depth, all.y }, middle.Shaded, to.Shaded, cell, halves);
  const Real error = max(differenceOf(whole, halves), differenceOf(even, halves)) / 3;
  if (isSettled(error, radiance.transmittance - halves.transmittance, halvings))
  {
    radiance = extrapolated(whole, halves, error);
    return lookups;
  }
  lookups = gatherBetween(thicknessPerDepth, from, middle, halvings + 1, cell, radiance);
  return isOpaque(radiance)
           ? lookups
           : lookups + gatherBetween(thicknessPerDepth, middle, to, halvings + 1, cell, radiance);
}

LitPoint endPoint(const CellInterval& cell, Real depth, Real inset)
{
  return { depth, shadeWithin(cell, depth + inset) };
}

// As gatherCell().
int gatherLit(Real thicknessPerDepth, CellInterval& cell, Radiance& radiance)
{
#if TETMARCH_NAN_SHOWN
  const bool lit = LightAtPoints && cell.finite;
#else
  const bool lit = LightAtPoints;
#endif
  if (!lit)
  {
    return gatherCell(thicknessPerDepth, cell, radiance);
  }
  const Real inset = (cell.end - cell.begin) * Real(Inset);
  return gatherBetween(thicknessPerDepth, endPoint(cell, cell.begin, inset),
    endPoint(cell, cell.end, -inset), 1, cell, radiance);
}
