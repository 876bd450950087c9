// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A window with an image or a rectilinear grid in it, and how far its pictures are from the
 * CPU reference
 */
#ifndef tetmarch_testing_StructuredScene_h
#define tetmarch_testing_StructuredScene_h

#include "vtkTetMarchSmartVolumeMapper.h"

#include "Reference/IncomingLight.h"

#include "LatticeImages.h"
#include "LatticeTruth.h"
#include "Scene.h"

#include <initializer_list>
#include <string>

namespace tetmarch::testing
{
/// Pixels along a side of the window: few, since the reference takes most of the time, and each ray
/// is one of its own.
constexpr int StructuredSize = 28;

using KindsOfValues = std::initializer_list<LatticeValues>;
const char* nameOf(LatticeValues values);

class StructuredScene
{
public:
  /// Diagnostics on, the bumpy functions, linear interpolation of the scalars of points, unit
  /// distance 0.25, seen by lookAtUnitCube().
  explicit StructuredScene(
    vtkDataSet* data, int width = StructuredSize, int height = StructuredSize);
  StructuredScene(const StructuredScene&) = delete;
  StructuredScene& operator=(const StructuredScene&) = delete;

  vtkVolumeProperty* property() { return this->Volume->GetProperty(); }
  bool isLit() { return this->property()->GetShade() || this->property()->HasGradientOpacity(); }
  vtkCamera* camera() { return this->Renderer->GetActiveCamera(); }
  void draw(LatticeValues values);
  /// All of the data from a corner, and a unit distance that is a share of its diagonal.
  void lookAtAll(double unitDistance = 0.3);
  /// The functions of the scene stretched from [0, 1] over another range.
  void stretchFunctions(double low, double high);
  void setSurfaces(const std::vector<double>& values);
  /// A light of the scene, from there to the middle of the unit cube.
  vtkSmartPointer<vtkLight> addLight(double x, double y, double z);

  /// One frame; returns the diagnostic picture.
  Image render();
  /// Of the frame before, by the CPU reference in double precision.
  Image truth();
  /// The same with light that is evaluated there.
  Image drawnWith(LightAt light);
  /// The diagnostic picture of the frame before.
  Image pixels() const;
  Image frame() const { return framePictureOf(this->Window); }

  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkTetMarchSmartVolumeMapper> Mapper;
};

/// The worst of all comparisons of a test.
struct Worst
{
  double Max = 0.0;
  double Rms = 0.0;
  double OverBound = 0.0; ///< of an error above the frame's greatest error bound
};

/// No ray lost or stopped, and some that met a cell.
void expectCounters(StructuredScene& scene);

/// Which promises a scene is held to, beside those of the counters.
struct Promises
{
  /// No error above the greatest error bound, which leaves out what functions do between the
  /// entries of their tables.
  bool Bound = true;
  /// The tolerance of the level Default does not cover light: there the error bound counts alone.
  bool DefaultTolerance = true;
};

/// Renders at the levels Default and Accurate and compares all pixels with the CPU reference, which
/// is the ground truth: at most 2/255 and an RMS of 0.3/255 off.
Worst expectParity(StructuredScene& scene, const Promises& promises = {});
/// Prints the figures.
void report(const std::string& what, const Worst& worst);
/// Both for each of these kinds of values.
void expectParityOf(KindsOfValues kinds, StructuredScene& scene, const std::string& what,
  const Promises& promises = {});

/// What jumps from pixel to pixel has edges, where rounding decides which side a pixel sees: at
/// most one in 250 pixels is off by more than 2/255.
void expectParityButForEdges(StructuredScene& scene, const std::string& what);

/// That a lattice and a mesh of the same field look the same to 0.5/255, but for the silhouette:
/// there the rasteriser decides which pixels see tetrahedra.
void expectPictureOfMesh(const Image& lattice, const Image& mesh, const std::string& what);

/// Light that is sampled at random points of rays is that of the reference to 1.5/255 RMS.
void expectLightAlongRays(StructuredScene& scene, const std::string& what);
/// That there are shadows then, and that they are those of the reference.
void expectShadowsAlongRays(KindsOfValues kinds, StructuredScene& scene);
} // namespace tetmarch::testing

#endif
