// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScalarBar.h"

#include "Overlay.h"
#include "Ticks.h"

#include "vtkColorTransferFunction.h"

#include <algorithm>

namespace tetmarch
{

void ScalarBar::AddTo(Overlay& overlay) const
{
  const double width = overlay.GetPictureSize()[0];
  const double height = overlay.GetPictureSize()[1];
  const double margin = 10.0 * this->Scale;
  const double thickness = 22.0 * this->Scale;
  const double tickLength = 5.0 * this->Scale;
  const double titleSize = 18.0 * this->Scale;
  const double wishedLabelSize = 15.0 * this->Scale;
  const double left = (1.0 - this->Share) * width + margin;
  const double right = width - margin;
  const double bottom = std::max(0.12 * height, 2.0 * margin);
  const double top = std::max(bottom + 1.0, std::min(0.84 * height, height - 3.0 * titleSize));
  const double titleHeight = top + 1.5 * titleSize;
  if (this->HasPlate)
  {
    overlay.AddRectangle({ { left - margin, bottom - margin } },
      { { width, titleHeight + titleSize } }, { { 0.1, 0.1, 0.1 } }, 0.75);
  }

  constexpr int steps = 256;
  for (int i = 0; i < steps; ++i)
  {
    std::array<double, 3> color;
    const double middle = (i + 0.5) / steps;
    this->Colors->GetColor(
      this->Range[0] + (this->Range[1] - this->Range[0]) * middle, color.data());
    overlay.AddRectangle({ { left, bottom + (top - bottom) * i / steps } },
      { { left + thickness, bottom + (top - bottom) * (i + 1) / steps } }, color);
  }

  const double spacing = std::max(3.0 * wishedLabelSize, (top - bottom) / 10);
  const std::vector<Tick> ticks =
    MakeTicks(this->Range[0], this->Range[1], static_cast<int>((top - bottom) / spacing));
  const double labelLeft = left + thickness + 2.0 * tickLength;
  const double labelSize =
    Overlay::FindSize(GetLabels(ticks), wishedLabelSize, width - 0.5 * margin - labelLeft);
  for (const Tick& tick : ticks)
  {
    const double share = (tick.Value - this->Range[0]) / (this->Range[1] - this->Range[0]);
    const double y = bottom + (top - bottom) * share;
    overlay.AddLine({ { left + thickness, y } }, { { left + thickness + tickLength, y } });
    overlay.AddText(tick.Label, labelSize, { { labelLeft, y } }, Overlay::LEFT);
  }
  overlay.AddText(this->Title, Overlay::FindSize({ this->Title }, titleSize, right - left),
    { { left, titleHeight } }, Overlay::LEFT);
}

} // namespace tetmarch
