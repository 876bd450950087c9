// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FurtherScalars.h"

#include <cmath>

namespace tetmarch
{
namespace
{

// valuesOf(component) are those of all vertices or tetrahedra, scalarOf(i) is the first scalar of
// one.
template <typename ValuesOf, typename ScalarOf>
FurtherScalars furtherScalars(const FurtherController& choice, ScalarRange& range,
  const ValuesOf& valuesOf, const ScalarOf& scalarOf)
{
  FurtherScalars further;
  const std::size_t count = choice.Components.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::vector<double> values = valuesOf(choice.Components[k]);
    const ScalarRange own = choice.Unit > 0 ? ScalarRange{ 0, choice.Unit } : finiteRange(values);
    further.Ranges.push_back(own);
    further.Values.resize(count * values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const bool finite = std::isfinite(values[i]);
      further.Values[count * i + k] = finite ? storedScalar(values[i], own) : 0.0f;
      if (!finite)
      {
        scalarOf(i) = UndrawnScalar;
        range.AllFinite = false;
      }
    }
  }
  return further;
}

} // namespace

FurtherScalars furtherPointScalars(vtkUnstructuredGrid* grid, vtkDataArray* array,
  const FurtherController& choice, TetMesh& mesh, ScalarRange& range)
{
  return furtherScalars(
    choice, range,
    [&](int component) {
      return pointValues(grid, array, mesh, { false, component });
    },
    [&](std::size_t i) -> float& { return mesh.Vertices[i].Scalar; });
}

FurtherScalars furtherCellScalars(vtkDataArray* array, const FurtherController& choice,
  const TetMesh& mesh, std::vector<float>& scalars, ScalarRange& range)
{
  return furtherScalars(
    choice, range,
    [&](int component) {
      return cellValues(array, mesh, { false, component });
    },
    [&](std::size_t i) -> float& { return scalars[i]; });
}

} // namespace tetmarch
