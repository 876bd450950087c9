// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchLegend.h"

#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkTextProperty.h"

namespace
{
// nullptr if the mode draws no measure.
const char* titleOf(int viewMode)
{
  switch (viewMode)
  {
    case vtkTetMarchVolumeMapper::VIEW_ERROR_BOUND:
      return "Error bound";
    case vtkTetMarchVolumeMapper::VIEW_CELLS:
      return "Cells crossed";
    case vtkTetMarchVolumeMapper::VIEW_LOOKUPS:
      return "Lookups";
    default:
      return nullptr;
  }
}
} // namespace

vtkStandardNewMacro(vtkTetMarchLegend);

//------------------------------------------------------------------------------
vtkTetMarchLegend::vtkTetMarchLegend()
{
  this->SetLabelFormat("%.3g");
  this->UnconstrainedFontSizeOn(); // else the labels of counts are larger than the title
  for (vtkTextProperty* text : { this->TitleTextProperty, this->LabelTextProperty })
  {
    text->SetFontSize(12); // text has a shadow, which makes it legible on bright colours
    text->BoldOff();
    text->ItalicOff();
  }
  this->SetPosition(0.8, 0.1);
  this->SetWidth(0.19); // the title fits into a window of 380 pixels
  this->SetVerticalTitleSeparation(6);
  this->SetMaximumWidthInPixels(110);
  this->SetMaximumHeightInPixels(400);
}

//------------------------------------------------------------------------------
vtkTetMarchLegend::~vtkTetMarchLegend() = default;

//------------------------------------------------------------------------------
void vtkTetMarchLegend::SetMapper(vtkTetMarchVolumeMapper* mapper)
{
  if (this->Mapper != mapper)
  {
    this->Mapper = mapper;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper* vtkTetMarchLegend::GetMapper() const { return this->Mapper; }

//------------------------------------------------------------------------------
bool vtkTetMarchLegend::IsShown() const
{
  return this->Mapper && titleOf(this->Mapper->GetViewMode()) &&
         this->Mapper->GetLastFrameStatistics()->GetNumberOfPixels(
           vtkTetMarchFrameStatistics::CELLS) > 0;
}

//------------------------------------------------------------------------------
int vtkTetMarchLegend::RenderOpaqueGeometry(vtkViewport*) { return 0; }

//------------------------------------------------------------------------------
int vtkTetMarchLegend::RenderOverlay(vtkViewport* viewport)
{
  if (!this->IsShown())
  {
    return 0;
  }
  this->SetTitle(titleOf(this->Mapper->GetViewMode()));
  this->SetLookupTable(this->Mapper->GetViewLookupTable());
  // The layout depends on this frame, so it is made here and not with opaque geometry.
  return this->RebuildLayoutIfNeeded(viewport) ? this->Superclass::RenderOverlay(viewport) : 0;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkTetMarchLegend::HasOpaqueGeometry() { return 0; }

//------------------------------------------------------------------------------
void vtkTetMarchLegend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper: " << this->Mapper.Get() << "\n";
}
