// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picking/SelectedCells.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// The largest float below 1: picked points are nearer than the background.
constexpr double Farthest = 1 - 1.0 / (1 << 24);

double windowDepth(const View& view, const std::array<double, 3>& p)
{
  const auto row = [&](int r)
  {
    const double* m = &view.NormalizedToClip[4 * r];
    return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
  };
  return std::clamp(0.5 + 0.5 * row(2) / row(3), 0.0, Farthest);
}

} // namespace

bool asksForCells(vtkHardwareSelector* selector)
{
  const int pass = selector->GetCurrentPass();
  return selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_CELLS &&
         pass != vtkHardwareSelector::POINT_ID_LOW24 &&
         pass != vtkHardwareSelector::POINT_ID_HIGH24;
}

std::vector<float> selectionTexels(vtkHardwareSelector* selector,
  const std::vector<PickedPoint>& points, const CellOrigins& origins, const View& view)
{
  selector->BeginRenderProp();
  const int pass = selector->GetCurrentPass();
  const bool low = pass == vtkHardwareSelector::CELL_ID_LOW24;
  const bool high = pass == vtkHardwareSelector::CELL_ID_HIGH24;
  const bool block = pass == vtkHardwareSelector::COMPOSITE_INDEX_PASS;
  std::array<float, 3> color{};
  selector->GetPropColorValue(color.data());

  std::vector<float> texels(4 * points.size(), 1.0f);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const PickedPoint& point = points[i];
    if (point.Hit)
    {
      const CellOrigin origin = origins.of(point.Cell);
      selector->UpdateMaximumCellId(origin.Cell);
      if (low || high)
      {
        vtkHardwareSelector::Convert(high ? origin.Cell >> 24 : origin.Cell, color.data());
      }
      else if (block)
      {
        vtkHardwareSelector::Convert(origin.Block, color.data());
      }
      std::copy(color.begin(), color.end(), &texels[4 * i]);
      texels[4 * i + 3] = static_cast<float>(windowDepth(view, point.Position));
    }
  }
  selector->EndRenderProp();
  return texels;
}

} // namespace tetmarch
