// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of one ray on the CPU, tetrahedron by tetrahedron: for those who ask why a pixel has
// the colour it has.
#ifndef TetMarchReferenceRayTrace_h
#define TetMarchReferenceRayTrace_h

#include "Diagnostics/MarchCounters.h"
#include "Mesh/TetMesh.h"
#include "Optics/AccuracyLevel.h"
#include "Scalars/DrawnScalars.h"

#include <array>
#include <vector>

namespace tetmarch
{

struct ReferenceScene;

/** How the ray of one pixel is marched by the CPU. */
struct TraceOptions
{
  int X = 0; // of the pixel, counted from the lower left of the window, or of the frame
  int Y = 0;
  AccuracyLevel Level = DefaultAccuracy;
  bool InDouble = false;
  bool IsTruth = false; // with the light of every point; else as the frame has it
};

/** Why something was gathered in a tetrahedron, or nothing. */
enum class CellOutcome
{
  Gathered,
  Transparent, // no scalar in it has extinction; in blend mode isosurface: it has no surface
  NotFinite,   // a scalar of it is not finite: it is drawn in the colour for that, or not at all
  Hidden,      // blanked, or a ghost
  Cropped,     // cropping leaves nothing of it
  OutOfRange,  // all of it lies before the ray's begin or behind its end
  Empty        // it has no length, is inverted, or lies where the ray has been already
};

/** A tetrahedron that a ray passed. Depths are in the normalised frame, along the ray. */
struct TracedCell
{
  Id Tet = 0;
  Id Cell = 0;             // of the input grid
  bool EntersMesh = false; // the ray comes in by a boundary face
  double Enter = 0;        // depths of the faces
  double Leave = 0;
  double Begin = 0; // of the part between them that lies within the ray's begin and end
  double End = 0;   //   and was not passed already
  std::array<double, MostComponents> ScalarEnter{}; // where the ray crosses the faces, as in the
  std::array<double, MostComponents> ScalarLeave{}; //   data; NaN if not finite
  CellOutcome Outcome = CellOutcome::Gathered;
  double Opacity = 0;            // of the cell alone; NaN where the blend mode has no such thing
  int Lookups = 0;               // of the segment integral in this cell
  std::array<double, 4> Color{}; // of a ray that ends behind the cell: premultiplied rgb, opacity
  double ErrorBound = 0;         // of that colour's channels
};

struct RayTrace
{
  int X = 0; // of the pixel, counted from the lower left of the viewport
  int Y = 0;
  int Components = 1;                // of the scalars
  std::array<double, 3> Origin{};    // on the near plane, in the normalised frame
  std::array<double, 3> Direction{}; // of length 1
  double OriginDepth = 0;            // the depth of that point
  double Begin = 0;                  // depths between which something is gathered: what the near
  double End = 0;                    //   plane, clipping planes and opaque geometry leave
  double ThicknessPerDepth = 0;      // length of a unit of depth, in scalar opacity unit distances
  std::vector<TracedCell> Cells;     // front to back
  bool Opaque = false;               // the ray ended since too little comes through
  std::array<double, 4> Color{};     // of the pixel: premultiplied rgb, opacity
  double ErrorBound = 0;
  MarchCounters Counters;
};

/**
 * The ray of one pixel of the scene's picture. It is marched by renderReference(), which records
 * what it does: the last colour is that of the picture's pixel. Real is float or double.
 */
template <typename Real>
RayTrace traceRay(const ReferenceScene& scene, const AccuracyLevel& level, int x, int y);

} // namespace tetmarch

#endif
