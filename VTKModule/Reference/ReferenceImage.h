// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole images on the CPU, by the march of the shaders.
#ifndef TetMarchReferenceReferenceImage_h
#define TetMarchReferenceReferenceImage_h

#include "Appearance/Blending.h"
#include "Appearance/Components.h"
#include "Diagnostics/MarchCounters.h"
#include "Light/EffectData.h"
#include "Mesh/HiddenCells.h"
#include "Mesh/TetMesh.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Parallel/Progress.h"
#include "Reference/IncomingLight.h"
#include "Scalars/ExtraScalars.h"
#include "Structured/Lattice.h"
#include "Structured/Octree.h"
#include "Structured/StoredValues.h"
#include "View/Clipping.h"
#include "View/RaySamples.h"
#include "View/View.h"

#include <array>
#include <vector>

namespace tetmarch
{

struct RayTrace;

/** What a picture is made of: tetrahedra, or the cells of a lattice with their values. The mesh
 * needs its hierarchy (ensureHierarchy). */
struct ReferenceScene
{
  const TetMesh* Mesh = nullptr;
  const Lattice* Cells = nullptr;       // takes the place of the mesh
  const Octree* Tree = nullptr;         // the cells are its leaves
  const StoredValues* Values = nullptr; // one for each scalar that is drawn
  const std::vector<float>* CellScalars =
    nullptr; // one a tetrahedron, or nullptr: those of the vertices
  const std::vector<std::array<float, 4>>* CornerScalars =
    nullptr; // of each tetrahedron's corners, if those of neighbours differ
  ScalarRange Range;
  bool NanShown = false;               // in the table's colour of scalars that are not finite
  const HiddenCells* Hidden = nullptr; // nullptr: none
  const IntegralTable* Table = nullptr;
  View Camera;
  int Width = 0; // of the viewport, in pixels
  int Height = 0;
  const float* WindowDepths = nullptr; // 0..1, one a pixel, of opaque geometry; nullptr: none
  Clipping Cut;                        // by default nothing is cut away
  RaySamples Samples;                  // for levels that sample the cells of a lattice
  const EffectData* Effects = nullptr;
  const Blending* Blend = nullptr;   // nullptr: composite; else the table is that of blendedTable()
  const Components* Parts = nullptr; // nullptr or single: one scalar; independent: without effects
  const ExtraScalars* Extra = nullptr; // of several components
  LightAt Light = LightAt::Points;
  /** Records its pixel's ray, and no other is cast; nullptr: all rays are, and none is recorded. */
  RayTrace* Trace = nullptr;
  /** Told of the share of the rays that were cast, from the calling thread; may be empty. */
  Progress Report;
};

struct ReferenceImage
{
  std::vector<float> Pixels;      // premultiplied r, g, b, alpha in 0..1; rows from the bottom
  std::vector<float> ErrorBounds; // of each pixel's channels, as the march has bounded it
  MarchCounters Counters;
  bool Stopped = false; // by the scene's report: pixels are lacking
};

/** In parallel; Real is float (the GPU's arithmetic) or double. */
template <typename Real>
ReferenceImage renderReference(const ReferenceScene& scene, const AccuracyLevel& level);

} // namespace tetmarch

#endif
