// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through the unit cube in any blend mode
 */
#ifndef tetmarch_testing_BlendedRays_h
#define tetmarch_testing_BlendedRays_h

#include "Appearance/Blending.h"
#include "Mesh/MeshScalars.h"

#include "CubeChord.h"
#include "RandomRays.h"
#include "RayTally.h"
#include "UnitMeshes.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tetmarch::testing
{
/// The cube with a field, red s, green 1 - s, blue 1/2, opacity 0.2 + 0.6 s.
class BlendedRays
{
public:
  static double opacity(double s) { return 0.2 + 0.6 * s; }
  static Rgba premultiplied(double s)
  {
    const double a = opacity(s);
    return { { s * a, (1 - s) * a, 0.5 * a, a } };
  }

  explicit BlendedRays(const Grid& grid, bool cells = false)
    : Mesh(builtWithHierarchy(grid))
  {
    vtkDataArray* array =
      cells ? grid->GetCellData()->GetScalars() : grid->GetPointData()->GetScalars();
    MeshScalars scalars = readScalars(grid, { array, cells }, this->Mesh);
    this->Range = scalars.Range;
    this->Scalars = std::move(scalars.OfCells);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.0, 1.0, 0.5);
    color->AddRGBPoint(1.0, 1.0, 0.0, 0.5);
    vtkNew<vtkPiecewiseFunction> opacities;
    opacities->AddPoint(0.0, opacity(0.0));
    opacities->AddPoint(1.0, opacity(1.0));
    this->Property->SetColor(color);
    this->Property->SetScalarOpacity(opacities);
  }

  /// Returns what is wrong.
  std::string use(BlendMode mode, const std::array<double, 2>& range = { { -1e38, 1e38 } })
  {
    const std::string error =
      makeBlending({ static_cast<int>(mode), range }, this->Property, this->Range, this->Blend);
    this->Table = blendedTable(
      this->Property, OpacityLaw::Structured, this->Blend, this->Range, GroundTruthAccuracy);
    return error;
  }
  std::string useSurfaces(const std::vector<double>& values)
  {
    vtkContourValues* contours = this->Property->GetIsoSurfaceValues();
    contours->SetNumberOfContours(static_cast<int>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      contours->SetValue(static_cast<int>(i), values[i]);
    }
    return this->use(BlendMode::IsoSurface);
  }

  template <typename Kernel>
  Kernel kernel() const
  {
    Kernel made =
      makeKernel<Kernel, RealOf<Kernel>>(this->Mesh, this->Table, this->Range, GroundTruthAccuracy);
    made.CellScalars = this->Scalars.data();
    made.useBlending(this->Blend);
    return made;
  }

  template <typename Ray>
  ScalarChord chordOf(const Ray& ray, const Field& field, double enlarged = 0.0) const
  {
    return cubeChord(this->Mesh.Frame.HalfExtent, ray, field, enlarged);
  }

  /// Calls check(ray, chord) with rays of all kinds through the cube, with all of their chord or a
  /// part of it, of a random thickness. Rays that graze a side are left out.
  template <typename Kernel, typename Function>
  void forEachRay(Kernel& kernel, const Field& field, const Function& check, int count = 600) const
  {
    RandomRays rays(7);
    for (int i = 0; i < count; ++i)
    {
      const auto ray = rays.template next<Kernel, RealOf<Kernel>>(kernel, this->Mesh);
      const ScalarChord inner = this->chordOf(ray, field, -1e-5),
                        outer = this->chordOf(ray, field, 1e-5);
      if (inner.End - inner.Begin < 0.05 ||
          outer.End - outer.Begin > inner.End - inner.Begin + 0.01)
      {
        continue;
      }
      ScalarChord chord = this->chordOf(ray, field);
      if (i % 3 == 0)
      {
        const double a = rays.uniformBetween(0.0, 0.4), b = rays.uniformBetween(0.6, 1.0);
        const double begin = chord.Begin + a * (chord.End - chord.Begin);
        const double end = chord.Begin + b * (chord.End - chord.Begin);
        chord = { begin, end, chord.scalarAt(begin), chord.scalarAt(end), 0 };
      }
      chord.Optical = rays.uniformBetween(0.1, 3.0);
      check(ray, chord);
    }
  }

  TetMesh Mesh;
  std::vector<float> Scalars; // of cells
  ScalarRange Range;
  vtkNew<vtkVolumeProperty> Property;
  Blending Blend;
  IntegralTable Table;
};
} // namespace tetmarch::testing

#endif
