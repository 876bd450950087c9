// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/FrameMeasures.h"

#include "GL/Diagnostics.h"

#include "vtkFloatArray.h"
#include "vtkTetMarchFrameStatistics.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// Of pixel i value(i), or -1, which the statistics leave out, if its ray met nothing and the pixel
// is not interpolated either.
template <typename Value>
void take(const Diagnostics& counted, vtkTetMarchFrameStatistics* statistics, int quantity,
  const Value& value)
{
  const std::vector<float>& measures = counted.measures();
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(measures.size() / 4));
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, measures[4 * i] > 0 || measures[4 * i + 3] > 0 ? value(i) : -1.0f);
  }
  statistics->SetValues(quantity, values);
}

} // namespace

void takeMeasures(const Diagnostics& counted, vtkTetMarchFrameStatistics* statistics)
{
  const auto component = [&](int c)
  { return [&counted, c](vtkIdType i) { return counted.measures()[4 * i + c]; }; };
  take(counted, statistics, vtkTetMarchFrameStatistics::CELLS, component(0));
  take(counted, statistics, vtkTetMarchFrameStatistics::LOOKUPS, component(1));
  take(counted, statistics, vtkTetMarchFrameStatistics::ERROR_BOUND, component(2));
}

void takeTrueErrors(
  const Diagnostics& counted, vtkFloatArray* reference, vtkTetMarchFrameStatistics* statistics)
{
  take(counted, statistics, vtkTetMarchFrameStatistics::TRUE_ERROR,
    [&](vtkIdType i)
    {
      float most = 0.0f;
      for (vtkIdType k = 4 * i; k < 4 * i + 4; ++k)
      {
        most = std::max(most, std::abs(counted.pixels()[k] - reference->GetValue(k)));
      }
      return most;
    });
}

} // namespace tetmarch
