// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What makes a scene show nothing, and what is said then
 */
#ifndef tetmarch_testing_BlankScenes_h
#define tetmarch_testing_BlankScenes_h

#include "ErrorScene.h"
#include "SmartScene.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>

namespace tetmarch::testing
{
struct ImageScene : SmartScene
{
  ImageScene(const vtkSmartPointer<vtkImageData>& image, int width, int height)
    : SmartScene(image, width, height)
    , Data(image)
  {
  }
  vtkSmartPointer<vtkImageData> Data;
};

inline Grid soundOf(const Scene*) { return jitteredLattice(4, 0.1, 1, sineField()); }
inline vtkSmartPointer<vtkImageData> soundOf(const ImageScene*)
{
  return imageOf(sineField(), unitCube(6));
}

template <typename Data>
Data madeNotFinite(Data data)
{
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, i % 2 ? std::nan("") : std::numeric_limits<double>::infinity());
  }
  scalars->Modified();
  data->Modified();
  return data;
}

template <typename SceneType>
void addPlane(SceneType& scene, double height, double up)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.5, height);
  plane->SetNormal(0.1 * up, 0.2 * up, up);
  scene.Mapper->AddClippingPlane(plane);
}

template <typename SceneType>
void setIsoValues(SceneType& scene, const std::vector<double>& values)
{
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.property()->GetIsoSurfaceValues()->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    scene.property()->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), values[i]);
  }
}

template <typename SceneType>
void setOpacities(SceneType& scene, const std::vector<std::array<double, 2>>& opacities)
{
  vtkNew<vtkPiecewiseFunction> function;
  for (const auto& [value, opacity] : opacities)
  {
    function->AddPoint(value, opacity);
  }
  scene.property()->SetScalarOpacity(function);
}

template <typename SceneType>
void cropTo(SceneType& scene, const std::array<double, 6>& planes, int flags)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(planes.data());
  scene.Mapper->SetCroppingRegionFlags(flags);
}

template <typename SceneType>
struct Blank
{
  std::string Name;
  void (*Spoil)(SceneType& scene);
  Words Said;
};

// The values of both are 0.1 to 0.9, about.
template <typename SceneType>
std::vector<Blank<SceneType>> blanks()
{
  return {
    { "not finite", [](SceneType& s) { madeNotFinite(s.Data); },
      { "none of the scalars is a finite number", "another array", "SetDrawNanCells" } },
    { "cells hidden",
      [](SceneType& s)
      { markCells(s.Data, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType) { return true; }); },
      { "every cell is hidden", "vtkGhostType" } },
    { "points hidden",
      [](SceneType& s)
      { markPoints(s.Data, vtkDataSetAttributes::HIDDENPOINT, [](vtkIdType) { return true; }); },
      { "every cell is hidden" } },
    { "no opacity",
      [](SceneType& s) {
        setOpacities(s, { { { 0, 0 } } });
      },
      { "opacity is 0 for all of the values of the array, 0", "opacity function" } },
    { "a preset beside",
      [](SceneType& s) {
        setOpacities(s, { { { 5, 0 } }, { { 9, 1 } } });
      },
      { "opacity is 0 for all" } },
    { "maximum of a preset beside",
      [](SceneType& s)
      {
        setOpacities(s, { { { 5, 0 } }, { { 9, 1 } } });
        s.Mapper->SetBlendModeToMaximumIntensity();
      },
      { "opacity is 0 for all" } },
    { "isosurfaces beside",
      [](SceneType& s) {
        setIsoValues(s, { -3.0, 2.5 });
      },
      { "no isosurface value lies among the values of the array, 0" } },
    { "no isosurfaces", [](SceneType& s) { setIsoValues(s, {}); }, { "no isosurface values" } },
    { "clear isosurfaces",
      [](SceneType& s)
      {
        setIsoValues(s, { 0.5 });
        setOpacities(s, { { { 0.45, 1 } }, { { 0.5, 0 } }, { { 0.55, 1 } } });
      },
      { "opacity is 0 at the isosurface values" } },
    { "averages beside",
      [](SceneType& s)
      {
        s.Mapper->SetBlendModeToAverageIntensity();
        s.Mapper->SetAverageIPScalarRange(7.0, 8.0);
      },
      { "averaged", "none of the values of the array, 0" } },
    { "clipped", [](SceneType& s) { addPlane(s, 1.8, 1.0); },
      { "clipping planes and cropping leave nothing", "RemoveAllClippingPlanes" } },
    { "between two planes",
      [](SceneType& s)
      {
        addPlane(s, 0.6, 1.0);
        addPlane(s, 0.4, -1.0);
      },
      { "leave nothing" } },
    { "cropped",
      [](SceneType& s) {
        cropTo(s, { 2, 3, 0, 1, 0, 1 }, 0x2000);
      },
      { "leave nothing", "CroppingOff" } },
    { "no region",
      [](SceneType& s) {
        cropTo(s, { 0.2, 0.8, 0.2, 0.8, 0.2, 0.8 }, 0);
      },
      { "leave nothing" } },
    { "regions beside",
      [](SceneType& s) {
        cropTo(s, { -3, -2, 0.2, 0.8, 0.2, 0.8 }, 0x2001);
      }, // no box
      { "leave nothing" } },
    { "cropped and clipped",
      [](SceneType& s)
      {
        cropTo(s, { 0, 1, 0, 1, 0.6, 1 }, 0x2000);
        addPlane(s, 0.3, -1.0);
      },
      { "leave nothing" } },
  };
}
} // namespace tetmarch::testing

#endif
