// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Groups.h"

#include "Grids.h"
#include "Views.h"

#include "vtkDataObject.h"
#include "vtkThreshold.h"

namespace tetmarch::testing
{
namespace
{
HardCase shapeCase(
  const std::string& name, const std::string& what, const std::function<Grid()>& make)
{
  HardCase hard;
  hard.Name = name;
  hard.Group = "non-convex";
  hard.What = what;
  hard.Make = make;
  return hard;
}

Grid swissCheese()
{
  const Grid whole = jitteredLattice(36, 0.15, 3, noiseField(5, 18));
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(whole);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "c");
  threshold->SetUpperThreshold(0.5);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->Update();
  Grid cheese = threshold->GetOutput();
  return cheese;
}

Grid besideCube(const Vec3& offset)
{
  const Grid cube = jitteredLattice(4, 0.0, 3, sineField());
  return joined(cube, withOffsetAndScale(cube, offset, 1.0));
}
} // namespace

void addNonConvexCases(HardCases& cases)
{
  cases.push_back(shapeCase(
    "torus", "a ring of radius 1, round of radius 0.4", [] { return torus(24, sineField()); }));
  cases.push_back(shapeCase("nested-shells", "a ball in shells with gaps between them",
    [] { return nestedShells(10, 4, 0.15, 1, sineField()); }));
  cases.push_back(shapeCase("cavity", "a cube with a closed hole",
    [] { return latticeWithHole(6, 0.15, 1, sineField()); }));
  cases.push_back(shapeCase(
    "tunnel", "a cube with a tunnel", [] { return latticeWithTunnel(6, 0.15, 1, sineField()); }));
  cases.push_back(shapeCase("l-shape", "an L", [] { return lShape(6, 0.15, 1, sineField()); }));
  cases.push_back(shapeCase("spiral", "a square spiral", [] { return spiral(4, sineField()); }));
  cases.push_back(shapeCase("sheets", "40 sheets one cell thick, 1e-5 apart",
    [] { return sheets(40, 3, 1e-5, sineField()); }));
  cases.push_back(shapeCase("comb", "a comb of 1000 teeth, which a ray enters 1000 times",
    [] { return comb(1000, sineField()); }));
  cases.back().Views = standardViews();
  // One row of pixels runs between bar and teeth, where rays meet twice as many faces.
  HardView along = parallelAlong("along-the-teeth-and-the-bar", { 1.0, 0.0, 0.0 }, 0.05);
  along.TwinOnly = true;
  cases.back().Views.push_back(along);
  cases.back().Views.push_back(parallelAlong("along-the-teeth", { 1.0, 1e-3, 0.0 }, 0.05));
  cases.push_back(shapeCase(
    "swiss-cheese", "what a threshold leaves of noise: 100 thousand boundary faces", swissCheese));
  cases.push_back(
    shapeCase("touching-faces", "two cubes that touch in a face, without common points",
      [] {
        return besideCube({ 1.0, 0.0, 0.0 });
      }));
  cases.push_back(shapeCase("touching-edges", "two cubes that touch in an edge",
    [] {
      return besideCube({ 1.0, 1.0, 0.0 });
    }));
  cases.push_back(shapeCase("touching-vertices", "two cubes that touch in a vertex",
    [] {
      return besideCube({ 1.0, 1.0, 1.0 });
    }));
  cases.push_back(shapeCase("overlapping-cubes", "two cubes, half of each in the other",
    [] {
      return besideCube({ 0.5, 0.0, 0.0 });
    }));
  cases.push_back(shapeCase("overlapping-askew", "two cubes that overlap in a corner",
    [] {
      return besideCube({ 0.3, 0.4, 0.55 });
    }));
}
} // namespace tetmarch::testing
