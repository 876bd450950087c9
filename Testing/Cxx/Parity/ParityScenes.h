// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The kinds of volumes that tests of parity draw, for suites of typed tests
 *
 * A test changes a scene of any kind in the same way. The kind has the data, and the tolerance of
 * its pictures. A class for another kind of data set, named in ParityKinds, gets all of these
 * tests.
 */
#ifndef tetmarch_testing_ParityScenes_h
#define tetmarch_testing_ParityScenes_h

#include "BlendParity.h"
#include "ComponentScene.h"
#include "StructuredScene.h"

#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <string>
#include <type_traits>

namespace tetmarch::testing
{
enum class Shape
{
  Plain,
  AlongAxes, ///< its cells are, in steps of 1/8
  Hard,      ///< rays come again to the mesh, and axes of the lattice are uneven
  FarAway,   ///< by FarOff
  Noise
};
constexpr Vec3 FarOff = { 1e6, -1e6, 2e6 };

/// Tetrahedra in the unit cube.
class MeshParity : public Scene
{
public:
  explicit MeshParity(Shape shape = Shape::Plain)
    : MeshParity(gridOf(shape))
  {
  }

  /// Kinds of data that differ in how rays meet cells.
  static void forEach(const std::function<void(MeshParity& scene, const std::string& name)>& check)
  {
    for (const auto& [name, grid] :
      { std::pair<const char*, Grid>{ "lattice", gridOf(Shape::Plain) },
        { "hole", latticeWithHole(9, 0.15, 1, sineField()) },
        { "tunnel", latticeWithTunnel(9, 0.15, 1, sineField()) },
        { "shells", gridOf(Shape::Hard) } })
    {
      MeshParity scene(grid);
      check(scene, name);
    }
  }

  static void forEachScalars(
    const std::function<void(MeshParity& scene, const std::string& name)>& check)
  {
    for (const bool cells : { false, true })
    {
      MeshParity scene;
      cells ? scene.drawConstantCells() : void();
      check(scene, cells ? "cells" : "points");
    }
    MeshParity scene(withJumps(gridOf(Shape::Plain), 0.2));
    check(scene, "corners");
  }

  /// At the level that is set.
  void expectParity(const std::string& what)
  {
    SCOPED_TRACE(what);
    std::cout << what << '\n';
    expectParityWithOpaque(*this);
  }
  void expectParityButForEdges(const std::string& what)
  {
    SCOPED_TRACE(what);
    std::cout << what << '\n';
    expectBlendModeParity(*this);
  }
  void setTransparentRanges() { setSpikyFunctions(this->property()); }
  void drawConstantCells() { this->Mapper->SetScalarModeToUseCellData(); }

private:
  explicit MeshParity(const Grid& grid)
    : Scene(grid, 96, 96)
  {
  }
  static Grid gridOf(Shape shape)
  {
    const Grid plain = jitteredLattice(10, 0.15, 1, sineField());
    return shape == Shape::AlongAxes ? jitteredLattice(8, 0.0, 1, sineField())
           : shape == Shape::Hard    ? nestedShells(10, 4, 0.15, 1, sineField())
           : shape == Shape::FarAway ? withOffsetAndScale(plain, FarOff, 1.0)
           : shape == Shape::Noise   ? jitteredLattice(6, 0.15, 1, noiseField(3, 4))
                                     : plain;
  }
};

/// An image or a rectilinear grid of the unit cube.
class LatticeParity : public StructuredScene
{
public:
  explicit LatticeParity(Shape shape = Shape::Plain)
    : StructuredScene(dataOf(shape))
  {
  }

  static void forEach(
    const std::function<void(LatticeParity& scene, const std::string& name)>& check)
  {
    for (const LatticeValues values : AllLatticeValues)
    {
      LatticeParity scene;
      scene.draw(values);
      check(scene, nameOf(values));
    }
  }

  static void forEachScalars(
    const std::function<void(LatticeParity& scene, const std::string& name)>& check)
  {
    forEach(check);
  }

  /// At the levels Default and Accurate.
  void expectParity(const std::string& what)
  {
    SCOPED_TRACE(what);
    vtkVolumeProperty* shown = this->property();
    const bool lit = shown->GetShade() != 0;
    const bool byGradients = shown->HasGradientOpacity();
    // The bound knows of gradients by the light that they reflect, of one component.
    const bool bound = !byGradients || (lit && this->components() == 1);
    report(what, tetmarch::testing::expectParity(*this, { bound, !lit && !byGradients }));
  }
  void expectParityButForEdges(const std::string& what)
  {
    SCOPED_TRACE(what);
    tetmarch::testing::expectParityButForEdges(*this, what);
  }
  /// Not narrow: the reference has no tables, which are too coarse for spikes.
  void setTransparentRanges() { setTwoPeaks(this->property()); }
  void drawConstantCells() { this->draw(LatticeValues::CellsNearest); }

private:
  int components() const
  {
    return this->Data->GetPointData()->GetScalars()->GetNumberOfComponents();
  }
  static vtkSmartPointer<vtkDataSet> dataOf(Shape shape)
  {
    if (shape == Shape::Hard)
    {
      return rectilinearOf(sineField(), unevenCube(8));
    }
    ImagePlace place = unitCube(8);
    if (shape == Shape::FarAway)
    {
      place.Origin = FarOff;
    }
    return shape == Shape::Noise ? imageOf(scatteredField(1), unitCube(6))
                                 : imageOf(sineField(), place);
  }
};

/// Draws several components, which replace the scalars.
template <typename Kind>
void drawMix(Kind& scene, const Mix& mix)
{
  setComponents(scene.Data, wavyFields(mix.Components), VTK_DOUBLE);
  setComponentFunctions(scene.property(), mix.Components);
  scene.property()->SetIndependentComponents(mix.Independent);
  if constexpr (std::is_same_v<Kind, MeshParity>)
  {
    scene.Mapper->SetVectorMode(mix.Independent ? Mapper::ALL_COMPONENTS : Mapper::DISABLED);
  }
}

using ParityKinds = ::testing::Types<MeshParity, LatticeParity>;
struct ParityKindNames
{
  template <typename Kind>
  static const char* GetName(int /*index*/)
  {
    return std::is_same_v<Kind, MeshParity> ? "Mesh" : "Lattice";
  }
};

/// A row of a table: what a test does to a scene before it is drawn.
template <typename Kind>
struct Case
{
  const char* Name;
  void (*Change)(Kind& scene);
};
} // namespace tetmarch::testing

#endif
