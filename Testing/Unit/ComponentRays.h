// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through the unit cube with an array of several components, each linear in space, and
 * what they see by a quadrature that has nothing in common with the march
 */
#ifndef tetmarch_testing_ComponentRays_h
#define tetmarch_testing_ComponentRays_h

#include "Appearance/Components.h"

#include "BlendedRays.h"
#include "ComponentFields.h"

namespace tetmarch::testing
{
class ComponentRays
{
public:
  /// Dependent components, 2 or 4 of them, unless `independent` is set. The transfer functions are
  /// those of setComponentFunctions().
  ComponentRays(const Grid& grid, int components, bool independent, bool cells = false)
    : Fields(componentFields(components))
    , Rays(withComponents(grid, this->Fields, VTK_DOUBLE), cells)
    , Data(grid)
    , OfCells(cells)
  {
    this->Property->SetIndependentComponents(independent);
    setComponentFunctions(this->Property, components);
  }

  /// Returns what is wrong.
  std::string use(const AccuracyLevel& level)
  {
    vtkDataArray* array = this->OfCells ? this->Data->GetCellData()->GetScalars()
                                        : this->Data->GetPointData()->GetScalars();
    DrawnScalars drawn;
    const std::string error = chooseScalars(
      this->Data, array, this->OfCells, { VectorMode::AllComponents, 0 }, this->Property, drawn);
    MeshScalars scalars = readScalars(this->Data, drawn, this->Rays.Mesh);
    this->Rays.Range = scalars.Range;
    this->Rays.Scalars = std::move(scalars.OfCells);
    this->Extra = std::move(scalars.Extra);
    this->Parts = {};
    this->Parts.Mix = drawn.Mix;
    this->Parts.ExtraRanges = this->Extra.Ranges;
    this->Rays.Table = componentTables(
      this->Property, OpacityLaw::Unstructured, this->Rays.Range, level, this->Parts);
    this->Level = level;
    return error.empty() ? setFactors(this->Property, this->Parts) : error;
  }

  template <typename Kernel>
  Kernel kernel() const
  {
    auto made = makeKernel<Kernel, RealOf<Kernel>>(
      this->Rays.Mesh, this->Rays.Table, this->Rays.Range, this->Level);
    made.CellScalars = this->Rays.Scalars.data();
    made.useComponents(this->Parts, this->Extra, this->Rays.Range);
    return made;
  }

  template <typename Kernel, typename Function>
  void forEachRay(Kernel& kernel, int count, const Function& check) const
  {
    this->Rays.forEachRay(kernel, this->Fields[0], check, count);
  }

  template <typename Ray>
  ScalarChord chordOf(const Ray& ray, const Field& field) const
  {
    return this->Rays.chordOf(ray, field);
  }

  /// Premultiplied colour and opacity of a part of a ray, in steps of the colour and extinction of
  /// their middles.
  template <typename Ray>
  Rgba truth(const Ray& ray, const ScalarChord& chord, int steps = 2000) const
  {
    std::vector<ScalarChord> wholes;
    for (const Field& field : this->Fields)
    {
      wholes.push_back(this->Rays.chordOf(ray, field));
    }
    std::vector<double> scalars(wholes.size());
    Rgba seen{};
    double through = 1;
    for (int i = 0; i < steps; ++i)
    {
      const double depth = chord.Begin + (chord.End - chord.Begin) * (i + 0.5) / steps;
      std::transform(wholes.begin(), wholes.end(), scalars.begin(),
        [depth](const ScalarChord& whole) { return whole.scalarAt(depth); });
      const Rgba medium = mediumAt(this->Property, scalars); // C tau, tau
      const double passed = std::exp(-medium[3] * chord.Optical / steps);
      for (int k = 0; k < 3 && medium[3] > 0; ++k)
      {
        seen[k] += through * (1 - passed) * medium[k] / medium[3];
      }
      through *= passed;
    }
    seen[3] = 1 - through;
    return seen;
  }

  template <typename Ray>
  Rgba inLight(const Ray&, const Rgba& color) const
  {
    return color;
  }

  std::vector<Field> Fields;
  BlendedRays Rays;
  Grid Data;
  bool OfCells;
  vtkNew<vtkVolumeProperty> Property;
  Components Parts;
  ExtraScalars Extra;
  AccuracyLevel Level = GroundTruthAccuracy;
};
} // namespace tetmarch::testing

#endif
