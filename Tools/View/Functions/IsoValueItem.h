// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_IsoValueItem_h
#define tetmarch_IsoValueItem_h

#include "vtkPlot.h"

#include <vector>

namespace tetmarch
{

/**
 * A vertical line at each isovalue, with a handle at its top, which the mouse drags. Whoever wants
 * to know of a drag observes InteractionEvent.
 */
class IsoValueItem : public vtkPlot
{
public:
  vtkTypeMacro(IsoValueItem, vtkPlot);
  static IsoValueItem* New();

  void SetIsoValues(const std::vector<double>& isoValues);
  const std::vector<double>& GetIsoValues() const { return this->IsoValues; }

  /// The values at 0 and at 1 of the chart's axis; a line can't be dragged beyond them.
  void SetAxis(double low, double high);

  /// Twice as large where a pixel is half as wide.
  void SetPixelRatio(double ratio) { this->PixelRatio = static_cast<float>(ratio); }

  bool Paint(vtkContext2D* painter) override;
  bool Hit(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonPressEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseMoveEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse) override;

protected:
  IsoValueItem() = default;
  ~IsoValueItem() override = default;

private:
  IsoValueItem(const IsoValueItem&) = delete;
  void operator=(const IsoValueItem&) = delete;

  /// A value where it is painted, and the value that is painted there.
  float ToScene(double value);
  double FromScene(float x);

  /// The line at most a few pixels from the mouse; -1 if there is none.
  int FindLine(const vtkContextMouseEvent& mouse);

  std::vector<double> IsoValues;
  double Low = 0.0;
  double High = 1.0;
  float PixelRatio = 1.0f;
  float PixelsPerUnit = 0.0f; ///< as it was painted last
  int Dragged = -1;
};

} // namespace tetmarch

#endif
