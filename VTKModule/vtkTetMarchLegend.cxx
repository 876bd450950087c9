// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchLegend.h"

#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSmartVolumeMapper.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkTextProperty.h"

namespace
{
// nullptr if the mode draws no measure.
const char* titleOf(int viewMode)
{
  switch (viewMode)
  {
    case vtkTetMarchSettings::VIEW_ERROR_BOUND:
      return "Error bound";
    case vtkTetMarchSettings::VIEW_CELLS:
      return "Cells crossed";
    case vtkTetMarchSettings::VIEW_LOOKUPS:
      return "Lookups";
    default:
      return nullptr;
  }
}

// The data of a mapper for the legend; all null for other classes.
struct Explained
{
  vtkTetMarchSettings* Settings = nullptr;
  vtkTetMarchFrameStatistics* Statistics = nullptr;
  vtkLookupTable* Table = nullptr;
};

template <typename Mapper>
Explained explain(Mapper* mapper)
{
  return { mapper->GetSettings(), mapper->GetLastFrameStatistics(), mapper->GetViewLookupTable() };
}

Explained explained(vtkAbstractVolumeMapper* any)
{
  if (auto* mapper = vtkTetMarchVolumeMapper::SafeDownCast(any))
  {
    return explain(mapper);
  }
  auto* mapper = vtkTetMarchSmartVolumeMapper::SafeDownCast(any);
  return mapper ? explain(mapper) : Explained();
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
void vtkTetMarchLegend::SetMapper(vtkAbstractVolumeMapper* mapper)
{
  if (this->Mapper != mapper)
  {
    this->Mapper = mapper;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkAbstractVolumeMapper* vtkTetMarchLegend::GetMapper() const { return this->Mapper; }

//------------------------------------------------------------------------------
bool vtkTetMarchLegend::IsShown() const
{
  const Explained frame = explained(this->Mapper);
  return frame.Settings && titleOf(frame.Settings->GetViewMode()) &&
         frame.Statistics->GetNumberOfPixels(vtkTetMarchFrameStatistics::CELLS) > 0;
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
  const Explained frame = explained(this->Mapper);
  this->SetTitle(titleOf(frame.Settings->GetViewMode()));
  this->SetLookupTable(frame.Table);
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
