// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a representation brings into a view of ParaView: its volume, and the legend of view modes.
#ifndef TetMarchVolumeInView_h
#define TetMarchVolumeInView_h

#include "vtkPVLODVolume.h"

class vtkTetMarchLegend;
class vtkView;

namespace tetmarch
{

/**
 * ParaView's volume draws nothing whose mapper has no single grid, but blocks have none. This one
 * leaves that to the mapper.
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
 * The legend comes into the view, over its picture, or no longer.
 */
void addLegend(vtkView* view, vtkTetMarchLegend* legend);
void removeLegend(vtkView* view, vtkTetMarchLegend* legend);
//@}

} // namespace tetmarch

#endif
