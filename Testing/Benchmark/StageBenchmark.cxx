// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Each stage of the preprocessing alone, on jittered lattices of 6 N^3 tetrahedra: for finding what
// to improve.
#include "Grids.h"
#include "Input/GridCheck.h"
#include "Input/GridContent.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/Convexity.h"
#include "Mesh/Decomposition.h"
#include "Mesh/HalfFaceLinks.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/MovedPoints.h"
#include "Mesh/Renumbering.h"
#include "Mesh/TetMeshBuilder.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/FittingTable.h"

#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkVolumeProperty.h"

#include <benchmark/benchmark.h>

#include <map>
#include <stdexcept>

namespace
{
using namespace tetmarch;

testing::Grid gridOf(const benchmark::State& state)
{
  static std::map<std::int64_t, testing::Grid> grids;
  testing::Grid& grid = grids[state.range(0)];
  if (!grid)
  {
    grid = testing::jitteredLattice(static_cast<int>(state.range(0)));
  }
  return grid;
}

void check(const std::string& error)
{
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
}

Decomposition decompositionOf(vtkUnstructuredGrid* grid)
{
  Decomposition tets;
  bool stopped = false;
  check(decompose(grid, {}, tets, stopped));
  return tets;
}

TetMesh unlinkedMeshOf(vtkUnstructuredGrid* grid)
{
  TetMesh mesh;
  bool stopped = false;
  check(renumber(grid->GetPoints(), decompositionOf(grid), {}, mesh, stopped));
  return mesh;
}

TetMesh meshOf(vtkUnstructuredGrid* grid)
{
  TetMesh mesh;
  std::string error;
  buildTetMesh(grid, {}, mesh, error);
  check(error);
  return mesh;
}

void countTets(benchmark::State& state)
{
  state.SetItemsProcessed(state.iterations() * gridOf(state)->GetNumberOfCells());
}

void CheckGrid(benchmark::State& state)
{
  const auto grid = gridOf(state);
  for (auto _ : state)
  {
    check(checkGrid(grid));
  }
  countTets(state);
}

/// With the check of the grid.
void Decompose(benchmark::State& state)
{
  const auto grid = gridOf(state);
  for (auto _ : state)
  {
    grid->Modified(); // else the verdict of the check is known
    benchmark::DoNotOptimize(decompositionOf(grid).Tets.data());
  }
  countTets(state);
}

void Renumber(benchmark::State& state)
{
  const auto grid = gridOf(state);
  const Decomposition tets = decompositionOf(grid);
  for (auto _ : state)
  {
    state.PauseTiming();
    Decomposition copy = tets;
    TetMesh mesh;
    bool stopped = false;
    state.ResumeTiming();
    check(renumber(grid->GetPoints(), std::move(copy), {}, mesh, stopped));
  }
  countTets(state);
}

void LinkHalfFaces(benchmark::State& state)
{
  const TetMesh unlinked = unlinkedMeshOf(gridOf(state));
  for (auto _ : state)
  {
    state.PauseTiming();
    TetMesh mesh = unlinked;
    state.ResumeTiming();
    linkHalfFaces({}, mesh);
  }
  countTets(state);
}

void IsConvex(benchmark::State& state)
{
  const TetMesh mesh = meshOf(gridOf(state));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(isConvex(mesh));
  }
  state.SetItemsProcessed(
    state.iterations() * static_cast<std::int64_t>(mesh.BoundaryFaces.size()));
}

void BuildHierarchy(benchmark::State& state)
{
  const TetMesh flat = meshOf(gridOf(state));
  for (auto _ : state)
  {
    state.PauseTiming();
    TetMesh mesh = flat;
    state.ResumeTiming();
    buildHierarchy(mesh);
  }
  state.SetItemsProcessed(
    state.iterations() * static_cast<std::int64_t>(flat.BoundaryFaces.size()));
}

void SetPointScalars(benchmark::State& state)
{
  const auto grid = gridOf(state);
  TetMesh mesh = meshOf(grid);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(readScalars(grid, { grid->GetPointData()->GetScalars() }, mesh));
  }
  state.SetItemsProcessed(state.iterations() * grid->GetNumberOfPoints());
}

/// What tells whether another grid has the same mesh.
void ReadContent(benchmark::State& state)
{
  const auto grid = gridOf(state);
  for (auto _ : state)
  {
    GridContent content;
    content.read(grid);
    benchmark::DoNotOptimize(&content);
  }
  countTets(state);
  const unsigned long kibibytes =
    grid->GetPoints()->GetActualMemorySize() + grid->GetCells()->GetActualMemorySize();
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(1024 * kibibytes));
}

void BuildTetMesh(benchmark::State& state)
{
  const auto grid = gridOf(state);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(meshOf(grid).Vertices.data());
  }
  countTets(state);
}

/// In place of BuildTetMesh where cells stay.
void MovePoints(benchmark::State& state)
{
  const auto grid = gridOf(state);
  TetMesh mesh = meshOf(grid);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(movePoints(grid, mesh));
  }
  countTets(state);
}

/// From the transfer functions to the table, with as many nodes as the argument says.
void MakeTable(benchmark::State& state)
{
  const auto nodes = static_cast<int>(state.range(0));
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int i = 0; i < nodes; ++i)
  {
    const double x = static_cast<double>(i) / (nodes - 1);
    color->AddRGBPoint(x, x, i % 2, 1.0 - x);
    opacity->AddPoint(x, i % 3 * 0.25);
  }
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  for (auto _ : state)
  {
    const IntegralTable table =
      fittingTable(property, OpacityLaw::Unstructured, 0.0, 1.0, DefaultAccuracy);
    benchmark::DoNotOptimize(table.Values.data());
  }
}

#define TETMARCH_STAGE_BENCHMARK(stage)                                                            \
  BENCHMARK(stage)->Arg(8)->Arg(30)->Arg(60)->Unit(benchmark::kMillisecond)->UseRealTime()

TETMARCH_STAGE_BENCHMARK(CheckGrid);
TETMARCH_STAGE_BENCHMARK(Decompose);
TETMARCH_STAGE_BENCHMARK(Renumber);
TETMARCH_STAGE_BENCHMARK(LinkHalfFaces);
TETMARCH_STAGE_BENCHMARK(IsConvex);
TETMARCH_STAGE_BENCHMARK(BuildHierarchy);
TETMARCH_STAGE_BENCHMARK(SetPointScalars);
TETMARCH_STAGE_BENCHMARK(ReadContent);
TETMARCH_STAGE_BENCHMARK(BuildTetMesh);
TETMARCH_STAGE_BENCHMARK(MovePoints);
BENCHMARK(MakeTable)->Arg(8)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();
} // namespace

BENCHMARK_MAIN();
