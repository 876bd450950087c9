// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Picks of the volume in one pixel, by a selector that has the window rendered.
#ifndef TetMarchMapperPickSession_h
#define TetMarchMapperPickSession_h

#include "Picking/PickedPoint.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkHardwareSelector;
class vtkRenderer;
class vtkVolume;

namespace tetmarch
{

class CellOrigins;
class MarchedVolume;

/** What is hit, and NaN, -1 and 0 if nothing is. */
struct Pick
{
  Pick();

  bool Hit = false;
  std::array<double, 3> Position; // in world coordinates
  double Scalar;                  // in units of the data
  vtkIdType Cell = -1;
  unsigned int Block = 0; // the flat index of the cell's block
};

class PickSession
{
public:
  /** What is hit in the middle of the pixel (x, y), counted from the lower left of the window.
   * `error` says why nothing can be picked, or is empty. */
  Pick pick(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, int x, int y,
    std::string& error);

  /** Keep the hit if these points were found for the selector of pick(). */
  void take(bool drawn, const std::vector<PickedPoint>& points, const CellOrigins& origins,
    vtkRenderer* renderer, vtkVolume* volume, const MarchedVolume& marched);

private:
  Pick capture(vtkRenderer* renderer, vtkVolume* volume, unsigned int x, unsigned int y);

  // Of the pick in progress.
  vtkHardwareSelector* Selector = nullptr;
  vtkVolume* Volume = nullptr;
  bool Failed = false;     // in one of the passes of the selector
  std::vector<Pick> Found; // of each block that is hit, whatever is before it
};

} // namespace tetmarch

#endif
