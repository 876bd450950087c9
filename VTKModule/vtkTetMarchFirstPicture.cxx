// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchFirstPictureInternals.h"

#include "Blocks/DataFaults.h"
#include "FirstPicture/ArrayTable.h"
#include "FirstPicture/DrawnBlocks.h"
#include "Input/SolidCells.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTetMarchSettings.h"
#include "vtkTetMarchSmartVolumeMapper.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUniformGridAMR.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

vtkStandardNewMacro(vtkTetMarchFirstPicture);

vtkTetMarchFirstPicture::vtkTetMarchFirstPicture()
  : Found(std::make_unique<Internals>())
{
}

vtkTetMarchFirstPicture::~vtkTetMarchFirstPicture() = default;

void vtkTetMarchFirstPicture::SetInputData(vtkDataObject* data)
{
  if (this->Found->Data != data)
  {
    this->Found->Data = data;
    this->Found->forget();
    this->Modified();
  }
}

vtkDataObject* vtkTetMarchFirstPicture::GetInputData() { return this->Found->Data; }

void vtkTetMarchFirstPicture::SetArrayName(const std::string& name)
{
  if (this->ArrayName != name)
  {
    this->ArrayName = name;
    this->Modified();
  }
}

std::string vtkTetMarchFirstPicture::GetArrayName() const { return this->ArrayName; }

bool vtkTetMarchFirstPicture::CheckData()
{
  Internals& found = *this->Found;
  if (!found.Data)
  {
    vtkErrorMacro("There is no data to choose for: call SetInputData() first.");
    return false;
  }
  const vtkMTimeType time = tetmarch::timeOf(found.Data);
  if (!found.IsChecked || time != found.Time)
  {
    found.forget();
    found.Time = time;
    found.Fault = found.check();
    found.IsChecked = true;
  }
  if (!found.Fault.empty())
  {
    vtkErrorMacro(<< found.Fault);
  }
  return found.Fault.empty();
}

bool vtkTetMarchFirstPicture::ListFaults(vtkStringArray* faults)
{
  if (!faults || !this->Found->Data)
  {
    vtkErrorMacro("An array to list the faults in, and data (SetInputData()) are needed.");
    return false;
  }
  faults->Initialize();
  std::string wrong;
  const auto drawn = this->Found->Made.replaceIn(this->Found->Data, wrong);
  for (const std::string& fault :
    drawn ? tetmarch::listFaults(drawn) : std::vector<std::string>{ wrong })
  {
    faults->InsertNextValue(fault);
  }
  return true;
}

std::string vtkTetMarchFirstPicture::Internals::check()
{
  std::string error;
  this->Drawn = this->Made.replaceIn(this->Data, error);
  return this->Drawn ? tetmarch::checkBlocks(this->Drawn) : error;
}

void vtkTetMarchFirstPicture::Internals::findBlocks()
{
  this->Owned = tetmarch::drawnBlocks(this->Drawn);
  this->Blocks.assign(this->Owned.begin(), this->Owned.end());
  // The blocks that mappers draw, unless there are none.
  std::vector<vtkDataSet*> solid;
  std::copy_if(
    this->Blocks.begin(), this->Blocks.end(), std::back_inserter(solid), tetmarch::hasSolidCells);
  this->Blocks = solid.empty() ? this->Blocks : solid;
  int n[3];
  this->Lattices = !vtkUniformGridAMR::SafeDownCast(this->Drawn) &&
                   std::all_of(this->Blocks.begin(), this->Blocks.end(),
                     [&n](vtkDataSet* block) { return tetmarch::isLattice(block, n); });
  this->Outline = tetmarch::outlinePoints(this->Blocks);
  this->Plane = tetmarch::choosePlane(this->Outline);
}

bool vtkTetMarchFirstPicture::CheckInput()
{
  if (!this->CheckData())
  {
    return false;
  }
  Internals& found = *this->Found;
  if (found.Blocks.empty())
  {
    found.findBlocks();
  }
  if (found.Blocks.empty())
  {
    vtkErrorMacro("The data has no cells to draw (" << found.Data->GetClassName() << ").");
    return false;
  }
  return true;
}

vtkDataArray* vtkTetMarchFirstPicture::GetChosenArray() { return this->Found->Chosen.Array; }

int vtkTetMarchFirstPicture::GetChosenAssociation() const
{
  return this->Found->Chosen.OfCells ? CELLS : POINTS;
}

int vtkTetMarchFirstPicture::GetChosenComponent() const { return this->Found->Chosen.Component; }

void vtkTetMarchFirstPicture::GetDataRange(double range[2])
{
  std::array<double, 2> all{ { 1.0, 0.0 } };
  if (this->Found->Chosen.Array)
  {
    all = tetmarch::rangeOf(this->Found->Blocks, this->Found->Chosen).value_or(all);
  }
  std::copy(all.begin(), all.end(), range);
}

vtkColorTransferFunction* vtkTetMarchFirstPicture::GetColor() { return this->Found->Color; }

vtkPiecewiseFunction* vtkTetMarchFirstPicture::GetOpacity() { return this->Found->Opacity; }

std::string vtkTetMarchFirstPicture::Describe()
{
  return tetmarch::describe(this->Found->Blocks, this->Found->Chosen);
}

bool vtkTetMarchFirstPicture::ListArrays(vtkTable* arrays)
{
  if (!arrays)
  {
    vtkErrorMacro("There is no table to list the arrays in.");
    return false;
  }
  arrays->Initialize();
  if (!this->CheckInput())
  {
    return false;
  }
  tetmarch::listArrays(this->Found->Blocks, arrays);
  return true;
}

bool vtkTetMarchFirstPicture::ApplyTo(vtkVolume* volume)
{
  if (!volume)
  {
    vtkErrorMacro("There is no volume to give the choice to.");
    return false;
  }
  const tetmarch::DrawnArray& chosen = this->Found->Chosen;
  if (!chosen.Array)
  {
    vtkErrorMacro("Nothing was chosen yet: call Choose() first.");
    return false;
  }
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetColor(this->Found->Color);
  property->SetScalarOpacity(this->Found->Opacity);
  property->SetScalarOpacityUnitDistance(this->UnitDistance);
  property->SetInterpolationTypeToLinear();
  auto* mapper = vtkAbstractVolumeMapper::SafeDownCast(volume->GetMapper());
  if (!mapper)
  {
    return true;
  }
  mapper->SetScalarMode(
    chosen.OfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(chosen.Array->GetName());
  const int law =
    this->UsesStructuredLaw() ? vtkTetMarchSettings::STRUCTURED : vtkTetMarchSettings::UNSTRUCTURED;
  const auto giveTo = [&chosen, law](auto* ours)
  {
    using Mapper = std::remove_pointer_t<decltype(ours)>;
    if (ours)
    {
      ours->GetSettings()->SetOpacityLaw(law);
      ours->SetVectorMode(chosen.Component < 0 ? Mapper::MAGNITUDE : Mapper::COMPONENT);
      ours->SetVectorComponent(std::max(0, chosen.Component));
    }
  };
  giveTo(vtkTetMarchVolumeMapper::SafeDownCast(mapper));
  giveTo(vtkTetMarchSmartVolumeMapper::SafeDownCast(mapper));
  return true;
}

void vtkTetMarchFirstPicture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InputData: " << this->Found->Data.Get() << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "ArrayAssociation: " << this->ArrayAssociation << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Range: " << this->Range[0] << ", " << this->Range[1] << "\n";
  os << indent << "OpacityLaw: " << this->OpacityLaw << "\n";
  os << indent << "FitWholeData: " << this->FitWholeData << "\n";
  os << indent << "ChosenRange: " << this->ChosenRange[0] << ", " << this->ChosenRange[1] << "\n";
  os << indent << "Background: " << this->Background << "\n";
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
}
