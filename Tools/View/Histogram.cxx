// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Histogram.h"

#include "VolumeData.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkTetMarchFirstPicture.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Bins = 256;

template <typename Tuple>
double GetValue(const Tuple& tuple, int component)
{
  if (component >= 0)
  {
    return static_cast<double>(tuple[component]);
  }
  double sum = 0.0;
  for (const auto part : tuple)
  {
    sum += static_cast<double>(part) * static_cast<double>(part);
  }
  return std::sqrt(sum);
}

void Count(vtkDataArray* array, int component, tetmarch::Histogram& histogram)
{
  const double scale = Bins / (histogram.High - histogram.Low);
  for (const auto tuple : vtk::DataArrayTupleRange(array))
  {
    const double value = GetValue(tuple, component);
    if (std::isfinite(value))
    {
      const double bin = std::clamp((value - histogram.Low) * scale, 0.0, Bins - 1.0);
      histogram.Counts[static_cast<std::size_t>(bin)] += 1.0;
    }
  }
}
} // namespace

tetmarch::Histogram tetmarch::CountValues(const VolumeData& data, vtkTetMarchFirstPicture* choice)
{
  Histogram histogram;
  histogram.Counts.assign(Bins, 0.0);
  double range[2];
  choice->GetDataRange(range);
  histogram.Low = range[0];
  histogram.High = range[1] > range[0] ? range[1] : range[0] + 1.0;
  const char* name = choice->GetChosenArray()->GetName();
  for (vtkDataSet* block : data.Blocks)
  {
    vtkDataArray* array = block->GetAttributes(choice->GetChosenAssociation())->GetArray(name);
    const int component =
      array && array->GetNumberOfComponents() == 1 ? 0 : choice->GetChosenComponent();
    if (array && component < array->GetNumberOfComponents())
    {
      Count(array, component, histogram);
    }
  }
  return histogram;
}
