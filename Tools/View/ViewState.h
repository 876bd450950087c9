// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All that decides a picture, as plain values: what is saved as a session, copied as a command line
 * or as a script of Python, and changed by the panels.
 */
#ifndef tetmarch_ViewState_h
#define tetmarch_ViewState_h

#include "SettingsState.h"

#include <array>
#include <string>
#include <vector>

namespace tetmarch
{

using Vector3 = std::array<double, 3>;

struct DataState
{
  std::string File;
  std::string Surface; // empty: none
  int TimeStep = -1;   // -1: the last
  std::string Array;   // empty: chosen
  int Association = -1;
  int Component = -2; // as vtkTetMarchFirstPicture::SetComponent()
  bool Nearest = false;
};

/// Transfer functions as lists of points.
struct FunctionState
{
  std::vector<std::array<double, 6>> Color; // x, r, g, b, midpoint, sharpness
  int ColorSpace = 0;                       // VTK_CTF_RGB
  bool HSVWrap = true;
  bool LogScale = false;
  std::array<double, 4> NanColor{ { 0.5, 0.0, 0.0, 1.0 } };
  std::vector<std::array<double, 4>> Opacity;         // x, opacity, midpoint, sharpness
  std::vector<std::array<double, 4>> GradientOpacity; // of the same
  double UnitDistance = 1.0;
  bool StructuredOpacityLaw = false;
};

struct CameraState
{
  Vector3 Position{ { 0.0, 0.0, 1.0 } };
  Vector3 FocalPoint{ { 0.0, 0.0, 0.0 } };
  Vector3 ViewUp{ { 0.0, 1.0, 0.0 } };
  double ViewAngle = 30.0;
  bool Parallel = false;
  double ParallelScale = 1.0;
};

struct EffectState
{
  bool GradientOpacity = false;
  bool Shading = false; // what follows, and settings of light, are drawn with it only
  bool Scattering = false;

  bool Headlight = false;
  Vector3 LightFrom{ { -0.6, -0.8, 1.0 } }; // from infinitely far
  double Intensity = 1.2;
  double Ambient = 0.4;
  double Diffuse = 0.8;
  double Specular = 0.2;
  double SpecularPower = 20.0;
  double ScatteringStrength = 1.0;
  double GradientStrength = 0.5; // opacity where the scalar is constant is one minus this
};

struct CutState
{
  bool Clip = false;
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  Vector3 Normal{ { 1.0, 0.0, 0.0 } }; // towards what is left
  bool Crop = false;
  std::array<double, 6> Box{ { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } };
};

struct ViewState
{
  DataState Data;
  FunctionState Functions;
  CameraState Camera;
  SettingsState Settings;
  EffectState Effects;
  CutState Cuts;
  int BlendMode = 0; // vtkVolumeMapper::COMPOSITE_BLEND
  std::vector<double> IsoValues;
  Vector3 Background{ { 0.08, 0.09, 0.12 } };
  std::array<int, 2> Size{ { 0, 0 } }; // of the picture in pixels
};

} // namespace tetmarch

#endif
