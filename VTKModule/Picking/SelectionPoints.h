// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The result of the first pass of a selection, for its later passes.
#ifndef TetMarchPickingSelectionPoints_h
#define TetMarchPickingSelectionPoints_h

#include "Caching/Fingerprint.h"
#include "Picking/PickedPoint.h"

#include "vtkWeakPointer.h"

#include <vector>

class vtkHardwareSelector;

namespace tetmarch
{

/**
 * A vtkHardwareSelector renders an unchanged scene several times, beginning with its ACTOR_PASS.
 * The points are kept until the selector's EndEvent.
 */
class SelectionPoints
{
public:
  SelectionPoints() = default;
  ~SelectionPoints() { this->clear(); }
  SelectionPoints(const SelectionPoints&) = delete;
  SelectionPoints& operator=(const SelectionPoints&) = delete;

  /** The points of an earlier pass of the selection with the same input; else null. */
  const std::vector<PickedPoint>* find(
    vtkHardwareSelector* selector, const Fingerprint& madeFrom) const;
  void keep(vtkHardwareSelector* selector, Fingerprint madeFrom, std::vector<PickedPoint> points);
  void clear();

private:
  vtkWeakPointer<vtkHardwareSelector> Selector;
  unsigned long Observer = 0; // of the selector
  Fingerprint MadeFrom;
  std::vector<PickedPoint> Points;
};

} // namespace tetmarch

#endif
