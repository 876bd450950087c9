// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All that the monkey test can set, as plain values: what is shown follows from them alone
 */
#ifndef tetmarch_testing_MonkeyState_h
#define tetmarch_testing_MonkeyState_h

#include "Scene.h"

#include "Variants/VariantKey.h"

#include <algorithm>
#include <string>
#include <vector>

namespace tetmarch::testing
{
using Mapper = vtkTetMarchVolumeMapper;

struct MonkeyPlane
{
  Vec3 Origin; ///< in the box of the volume, 0..1 each
  Vec3 Normal;
};

struct MonkeySize
{
  int Width;
  int Height;
};
constexpr MonkeySize MonkeySizes[] = { { 40, 32 }, { 1, 1 }, { 17, 41 }, { 64, 48 }, { 96, 80 },
  { 3, 2 } };

struct MonkeyState
{
  enum FunctionKind
  {
    Bumpy,
    Spiky,
    OneColor,
    Invisible,
    Gray,
    FunctionKinds
  };
  enum ArrayKind
  {
    OfPoints,
    OfCells,
    Absent,
    ArrayKinds
  };
  enum ViewKind
  {
    Views = 6, ///< the views from outside are 0 to 5
    Inside = Views,
    NearPlaneInside,
    Away,
    ViewKinds
  };
  enum LightKind
  {
    NoLight,
    Headlight,
    Sun,
    SunAndPointLight,
    AllLights,
    LightKinds
  };
  enum PlacementKind
  {
    AtHome,
    Turned,
    Stretched,
    Mirrored,
    Flat, ///< which is refused
    PlacementKinds
  };

  // Data.
  int Dataset = 0;
  int Step = 0;
  bool Moved = false;
  int Array = OfPoints;
  int VectorMode = Mapper::DISABLED;
  int VectorComponent = 0;

  // The volume and its property.
  int Placement = AtHome;
  int Functions = Bumpy;
  int Edit = 0; ///< of the opacity function; 0: none
  double UnitDistance = 0.25;
  bool Shade = false;
  double Ambient = 0.2;
  double Specular = 0.3;
  bool GradientOpacity = false;
  int IsoValues = 3;

  // The mapper.
  int BlendMode = Mapper::COMPOSITE_BLEND;
  int OpacityLaw = Mapper::UNSTRUCTURED;
  double AverageLow = -1e30;
  bool DrawNan = false;
  int Accuracy = Mapper::DEFAULT;
  double Tolerance = 1.0 / 255.0;
  double FrameTimeBudget = 0.0;
  double ErrorBudget = 0.0;
  double MaxDrawTime = 0.25;
  int ShaderStage = Mapper::AUTOMATIC_STAGE;
  bool Diagnostics = false;
  int ViewMode = Mapper::VIEW_PICTURE;
  bool AutomaticRange = true;
  double RangeLow = 1e-6;
  int GradientType = Mapper::VERTEX_GRADIENTS;
  int Shadows = Mapper::SHADOWS_OFF;
  bool OpaqueShadows = false;
  float Scattering = 0.0f;
  float Reach = 1.0f;
  bool Occlusion = false;
  int Directions = 4;
  double LightTimeBudget = 0.1;
  bool AutoDistance = true;
  double SampleDistance = 1.0;
  vtkIdType MaxMemory = 0;
  double PickOpacity = 0.5;
  std::vector<MonkeyPlane> Planes;
  bool Cropping = false;
  int CroppingFlags = VTK_CROP_SUBVOLUME;
  double CroppingLow = 0.25; ///< of each axis, in the box of the data; the high ones at 0.75

  // The rest of the scene.
  bool Ball = false;    ///< opaque
  int Translucent = 0;  ///< surfaces
  bool Peeling = false; ///< of surfaces
  bool PeelsVolume = false;
  int Lights = Headlight;
  double SunPlace = 2.0;
  bool TwoSided = true;
  int View = 0;
  double Distance = 2.4; ///< of the eye, in radii
  bool Parallel = false;
  bool SecondRenderer = false; ///< beside the first one, with the same volume
  int Size = 0;
  int Samples = 0; ///< of multisampling, where nothing is peeled
  double Background = 0.2;
  double UpdateRate = 0.0001; ///< from 1 on somebody interacts

  /// Of the window. Where a renderer has no pixel, VTK draws translucent surfaces into a
  /// framebuffer without any, which is a GL error.
  int width() const
  {
    const int wanted = MonkeySizes[this->Size].Width;
    return this->SecondRenderer && this->Translucent > 0 ? std::max(2, wanted) : wanted;
  }
  bool peels() const { return this->Translucent > 0 && this->Peeling && this->PeelsVolume; }
  bool isInside() const { return this->View == Inside || this->View == NearPlaneInside; }
  bool isBlended() const { return this->BlendMode != Mapper::COMPOSITE_BLEND; }
  bool showsBoundary() const
  {
    return !this->peels() && this->ViewMode >= Mapper::VIEW_BOUNDARY_FACES;
  }
  bool showsMeasure() const
  {
    return !this->peels() && this->ViewMode >= Mapper::VIEW_ERROR_BOUND &&
           this->ViewMode <= Mapper::VIEW_LOOKUPS;
  }
};

/// The same state without what depends on the speed of frames: its picture is always the same.
MonkeyState atRest(const MonkeyState& state);

/// The same with budgets of time that every frame keeps, or none, however fast the machine is. So
/// the controllers take the same levels and distances whenever the same steps are made.
MonkeyState timeless(const MonkeyState& state);

/// The same with all that is refused put right.
MonkeyState mended(const MonkeyState& state);

/// The variant of the shader that the state needs, as far as can be said without the mesh.
VariantKey variantOf(const MonkeyState& state);

/// Words of the errors that the state calls for, of which the mapper reports the first that it
/// meets; empty if there must be none.
std::vector<std::string> refusalsOf(const MonkeyState& state);
} // namespace tetmarch::testing

#endif
