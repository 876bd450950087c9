// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What records a march, as members of a kernel; part of KernelBody.h. Shaders/march/march.glsl
// calls traceCell(). Depths and scalars are recorded as the march has them.

RayTrace* Trace = nullptr;    // nullptr: nothing is recorded
Real TracedTransmittance = 1; // before the last cell
int TracedLookups = 0;

// A ray through a point of the near plane, of which something is gathered between two depths.
void beginTrace(const glsl::Vec3<double>& point, const glsl::Vec3<double>& direction, vec2 range,
  Real thicknessPerDepth)
{
  if (Trace)
  {
    Trace->Origin = { { point.x, point.y, point.z } };
    Trace->Direction = { { direction.x, direction.y, direction.z } };
    Trace->OriginDepth = glsl::dot(point, direction);
    Trace->Begin = double(range.x);
    Trace->End = double(range.y);
    Trace->ThicknessPerDepth = double(thicknessPerDepth);
    TracedTransmittance = 1;
    TracedLookups = 0;
  }
}

// A tetrahedron was stepped through, of which nothing is gathered yet.
void traceCell(const CellInterval& cell, const March& march)
{
  if (Trace)
  {
    completeCell(march);
    TracedCell traced;
    traced.Tet = cell.number;
    traced.Enter = double(cell.enter.x);
    traced.Leave = double(cell.leave.x);
    traced.Begin = double(cell.begin);
    traced.End = double(cell.end);
    traced.Outcome = outcomeOf(cell);
    traceScalars(cell, traced);
    Trace->Cells.push_back(traced);
  }
}

void endTrace(const March& march)
{
  if (Trace)
  {
    completeCell(march);
    Trace->Opaque = isOpaque(march.radiance);
    Trace->Color = tracedColor(march.radiance);
    Trace->ErrorBound = double(errorBound(march.radiance));
  }
}

// What the last cell has done to the ray.
void completeCell(const March& march)
{
  if (!Trace->Cells.empty())
  {
    TracedCell& last = Trace->Cells.back();
    last.Color = tracedColor(march.radiance);
    last.ErrorBound = double(errorBound(march.radiance));
    last.Lookups = march.lookups - TracedLookups;
    TracedLookups = march.lookups;
#if TETMARCH_ACCUMULATES_OPACITY
    last.Opacity = double(Real(1) - march.radiance.transmittance / TracedTransmittance);
    TracedTransmittance = march.radiance.transmittance;
#else
    last.Opacity = std::numeric_limits<double>::quiet_NaN();
#endif
    // Cropping comes last, and each part that it leaves takes a lookup.
    if (last.Outcome == CellOutcome::Gathered && last.Lookups == 0)
    {
      last.Outcome = CellOutcome::Cropped;
    }
  }
}

std::array<double, 4> tracedColor(const Radiance& radiance)
{
  const vec4 color = pixelOf(radiance, Real(Trace->ThicknessPerDepth));
  return { { double(color.x), double(color.y), double(color.z), double(color.w) } };
}

CellOutcome outcomeOf(const CellInterval& cell)
{
  if (!(cell.end > cell.begin))
  {
    const bool outside = double(cell.leave.x) <= Trace->Begin || double(cell.enter.x) >= Trace->End;
    return outside && cell.leave.x > cell.enter.x ? CellOutcome::OutOfRange : CellOutcome::Empty;
  }
#if TETMARCH_HIDDEN_CELLS
  if (isHidden(cell.number))
  {
    return CellOutcome::Hidden;
  }
#endif
#if TETMARCH_POINT_SCALARS
  const bool finite = isDrawn(cell.enter.y) && isDrawn(cell.leave.y);
#else
  const bool finite = isDrawn(cell.scalar);
#endif
  if (!finite)
  {
    return CellOutcome::NotFinite;
  }
  return cell.seen ? CellOutcome::Gathered : CellOutcome::Transparent;
}

void traceScalars(const CellInterval& cell, TracedCell& traced)
{
#if TETMARCH_POINT_SCALARS
  traced.ScalarEnter[0] = double(cell.enter.y);
  traced.ScalarLeave[0] = double(cell.leave.y);
#else
  traced.ScalarEnter[0] = traced.ScalarLeave[0] = double(cell.scalar);
#endif
#if TETMARCH_COMPONENTS
#if TETMARCH_EXTRA_VERTEX_SCALARS
  const vec3 enter = cell.enterAttributes.extra, leave = cell.leaveAttributes.extra;
#elif TETMARCH_BENT_COMPONENTS
  const vec3 enter = cell.extraEnter, leave = cell.extraLeave;
#elif TETMARCH_STRUCTURED
  const vec3 enter = cell.extra, leave = enter;
#else
  const vec3 enter = fetchExtraScalars(cell.number), leave = enter;
#endif
  const Real enters[] = { enter.x, enter.y, enter.z }, leaves[] = { leave.x, leave.y, leave.z };
  for (int k = 1; k < componentCount; ++k)
  {
    traced.ScalarEnter[k] = double(enters[k - 1]);
    traced.ScalarLeave[k] = double(leaves[k - 1]);
  }
#endif
}
