// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/TraceTable.h"

#include "GL/Pipeline.h"
#include "Mapper/MapperState.h"
#include "Reference/RayTrace.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVolume.h"

#include <cmath>

namespace tetmarch
{
namespace
{

using Triple = std::array<double, 3>;

const char* nameOf(CellOutcome outcome)
{
  constexpr const char* names[] = { "gathered", "transparent", "not finite", "hidden", "cropped",
    "out of range", "empty" };
  return names[static_cast<int>(outcome)];
}

// A ray in the world. Lengths along it are counted from its origin.
struct WorldRay
{
  Triple Origin{};
  Triple Direction{};
  double OriginDepth = 0;
  double LengthPerDepth = 0;

  WorldRay(const RayTrace& trace, const VolumeFrame& frame, vtkVolume* volume)
    : OriginDepth(trace.OriginDepth)
  {
    const Vector3 origin = frame.toData(trace.Origin);
    double point[4] = { origin[0], origin[1], origin[2], 1 };
    double direction[4] = { 0, 0, 0, 0 };
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = frame.Radius * trace.Direction[k];
    }
    volume->GetMatrix()->MultiplyPoint(point, point);
    volume->GetMatrix()->MultiplyPoint(direction, direction);
    this->LengthPerDepth = std::hypot(direction[0], direction[1], direction[2]);
    for (int k = 0; k < 3; ++k)
    {
      this->Origin[k] = point[k];
      this->Direction[k] = direction[k] / this->LengthPerDepth;
    }
  }

  double lengthAt(double depth) const { return (depth - this->OriginDepth) * this->LengthPerDepth; }
};

// Adds an array of the type Array, of the tuples valuesOf(0), valuesOf(1), ...
template <typename Array, typename ValuesOf>
void addArray(vtkFieldData* data, const char* name, std::size_t tuples, int components,
  const ValuesOf& valuesOf)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  for (std::size_t i = 0; i < tuples; ++i)
  {
    const auto values = valuesOf(i);
    for (int k = 0; k < components; ++k)
    {
      array->SetValue(static_cast<vtkIdType>(i) * components + k, values[k]);
    }
  }
  data->AddArray(array);
}

template <typename Array, typename ValueOf>
void addColumn(vtkTable* table, const RayTrace& trace, const char* name, const ValueOf& valueOf)
{
  addArray<Array>(table->GetRowData(), name, trace.Cells.size(), 1,
    [&](std::size_t i) { return std::array{ valueOf(trace.Cells[i]) }; });
}

template <typename ValuesOf>
void addColumns(vtkTable* table, const RayTrace& trace, const char* name, int components,
  const ValuesOf& valuesOf)
{
  addArray<vtkDoubleArray>(table->GetRowData(), name, trace.Cells.size(), components,
    [&](std::size_t i) { return valuesOf(trace.Cells[i]); });
}

template <typename Array, typename Values>
void addFact(vtkTable* table, const char* name, const Values& values)
{
  addArray<Array>(table->GetFieldData(), name, 1, static_cast<int>(values.size()),
    [&](std::size_t) { return values; });
}

void addPlaces(vtkTable* table, const RayTrace& trace, const WorldRay& ray)
{
  const auto add = [&](const char* name, double TracedCell::*depth)
  {
    addColumn<vtkDoubleArray>(
      table, trace, name, [&](const TracedCell& cell) { return ray.lengthAt(cell.*depth); });
  };
  add("Enter", &TracedCell::Enter);
  add("Leave", &TracedCell::Leave);
  add("Begin", &TracedCell::Begin);
  add("End", &TracedCell::End);
}

void addCells(vtkTable* table, const RayTrace& trace, const CellOrigins& origins, bool hasBlocks)
{
  addColumn<vtkIdTypeArray>(
    table, trace, "CellId", [&](const TracedCell& cell) { return origins.of(cell.Cell).Cell; });
  addColumn<vtkIntArray>(table, trace, "Block",
    [&](const TracedCell& cell)
    { return hasBlocks ? static_cast<int>(origins.of(cell.Cell).Block) : 0; });
  addColumn<vtkIdTypeArray>(
    table, trace, "Tetrahedron", [](const TracedCell& cell) { return vtkIdType(cell.Tet); });
}

void addOptics(vtkTable* table, const RayTrace& trace)
{
  addColumns(table, trace, "ScalarEnter", trace.Components,
    [](const TracedCell& cell) { return cell.ScalarEnter; });
  addColumns(table, trace, "ScalarLeave", trace.Components,
    [](const TracedCell& cell) { return cell.ScalarLeave; });
  addColumn<vtkDoubleArray>(
    table, trace, "Opacity", [](const TracedCell& cell) { return cell.Opacity; });
  addColumn<vtkIntArray>(
    table, trace, "Lookups", [](const TracedCell& cell) { return cell.Lookups; });
  addColumns(table, trace, "Color", 4, [](const TracedCell& cell) { return cell.Color; });
  addColumn<vtkDoubleArray>(
    table, trace, "ErrorBound", [](const TracedCell& cell) { return cell.ErrorBound; });
  addColumn<vtkIntArray>(
    table, trace, "EntersMesh", [](const TracedCell& cell) { return cell.EntersMesh ? 1 : 0; });
  addColumn<vtkStringArray>(table, trace, "Outcome",
    [](const TracedCell& cell) { return std::string(nameOf(cell.Outcome)); });
}

void addFacts(vtkTable* table, const RayTrace& trace, const WorldRay& ray)
{
  addFact<vtkDoubleArray>(table, "Color", trace.Color);
  addFact<vtkDoubleArray>(table, "ErrorBound", std::array{ trace.ErrorBound });
  addFact<vtkIntArray>(table, "Opaque", std::array{ trace.Opaque ? 1 : 0 });
  addFact<vtkDoubleArray>(table, "Origin", ray.Origin);
  addFact<vtkDoubleArray>(table, "Direction", ray.Direction);
  addFact<vtkDoubleArray>(
    table, "Range", std::array{ ray.lengthAt(trace.Begin), ray.lengthAt(trace.End) });
  addFact<vtkDoubleArray>(
    table, "ThicknessPerLength", std::array{ trace.ThicknessPerDepth / ray.LengthPerDepth });
  const auto& counters = trace.Counters;
  const auto addCount = [table](const char* name, std::int64_t count)
  { addFact<vtkIdTypeArray>(table, name, std::array{ vtkIdType(count) }); };
  addCount("Lookups", counters.Lookups);
  addCount("RefusedEntries", counters.Refused);
  addCount("LostRays", counters.Lost);
  addCount("GuardHits", counters.Guarded);
}

} // namespace

std::string traceRay(Pipeline& pipeline, const MapperState& state, const TracedPixel& pixel,
  const CellOrigins& origins, bool hasBlocks, vtkTable* cells)
{
  const std::string noRay = "No ray is traced: ";
  cells->Initialize();
  if (!pixel.Volume)
  {
    return noRay + "no volume was given.";
  }
  if (pixel.Arithmetic < 0 || pixel.Arithmetic > static_cast<int>(TraceArithmetic::GroundTruth))
  {
    return noRay + "the arithmetic is none of TraceArithmeticType.";
  }
  pipeline.makeCurrent();
  const auto arithmetic = static_cast<TraceArithmetic>(pixel.Arithmetic);
  const bool truth = arithmetic == TraceArithmetic::GroundTruth;
  const TraceOptions options{ pixel.X, pixel.Y,
    truth ? GroundTruthAccuracy : state.Accuracy.used().level(),
    arithmetic != TraceArithmetic::Float, truth };
  RayTrace trace;
  const StageResult result = pipeline.traceRay(pixel.Volume->GetProperty(), options, trace);
  if (!result.isDone())
  {
    return noRay + result.Error;
  }
  const WorldRay ray(trace, pipeline.stages().volume().frame(), pixel.Volume);
  addCells(cells, trace, origins, hasBlocks);
  addPlaces(cells, trace, ray);
  addOptics(cells, trace);
  addFacts(cells, trace, ray);
  return {};
}

} // namespace tetmarch
