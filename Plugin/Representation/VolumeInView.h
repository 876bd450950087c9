// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The props of a representation in a view of ParaView: its volume, and the legend of view modes.
#ifndef TetMarchVolumeInView_h
#define TetMarchVolumeInView_h

#include "vtkPVLODVolume.h"

class vtkTetMarchLegend;
class vtkView;

namespace tetmarch
{

/**
 * ParaView's volume requires a mapper with a single grid, which blocks lack. This class has no such
 * requirement.
 */
class BlocksVolume : public vtkPVLODVolume
{
public:
  static BlocksVolume* New();
  vtkTypeMacro(BlocksVolume, vtkPVLODVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override;

protected:
  BlocksVolume() = default;
  ~BlocksVolume() override = default;

private:
  BlocksVolume(const BlocksVolume&) = delete;
  void operator=(const BlocksVolume&) = delete;
};

//@{
/**
 * Add the legend to the view, over its picture, or remove it.
 */
void addLegend(vtkView* view, vtkTetMarchLegend* legend);
void removeLegend(vtkView* view, vtkTetMarchLegend* legend);
//@}

} // namespace tetmarch

#endif
