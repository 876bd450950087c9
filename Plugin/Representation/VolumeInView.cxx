// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeInView.h"

#include "vtkLODProp3D.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkTetMarchLegend.h"

namespace tetmarch
{

vtkStandardNewMacro(BlocksVolume);

int BlocksVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  const int drawn = this->LODProp->RenderVolumetricGeometry(viewport);
  this->EstimatedRenderTime = this->LODProp->GetEstimatedRenderTime();
  return drawn;
}

// Not composited: each process composites its own piece of the volume, but only the one that shows
// the picture may add a legend. It draws after the others.
void addLegend(vtkView* view, vtkTetMarchLegend* legend)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetNonCompositedRenderer()->AddViewProp(legend);
  }
}

void removeLegend(vtkView* view, vtkTetMarchLegend* legend)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetNonCompositedRenderer()->RemoveViewProp(legend);
  }
}

} // namespace tetmarch
