// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchImageReader.h"

#include "ImageFiles/ImageHeader.h"
#include "ImageFiles/ImageValues.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <optional>

struct vtkTetMarchImageReader::Found
{
  std::optional<tetmarch::ImageHeader> Header; // none: it was refused
};

vtkStandardNewMacro(vtkTetMarchImageReader);

vtkTetMarchImageReader::vtkTetMarchImageReader()
  : Header(std::make_unique<Found>())
{
  this->SetNumberOfInputPorts(0);
}

vtkTetMarchImageReader::~vtkTetMarchImageReader() { this->SetFileName(nullptr); }

void vtkTetMarchImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

void vtkTetMarchImageReader::Refuse(const std::string& reason)
{
  this->Header->Header.reset();
  this->SetErrorCode(vtkErrorCode::FileFormatError);
  vtkErrorMacro(<< reason);
}

// A refusal is an error of the reader only; a failed request would be one of its executive, too.
int vtkTetMarchImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Header->Header.reset();
  if (!this->FileName)
  {
    this->Refuse("no name of a file is set");
    return 1;
  }
  try
  {
    this->Header->Header = tetmarch::readImageHeader(this->FileName);
    tetmarch::checkImageFiles(*this->Header->Header);
  }
  catch (const tetmarch::ImageFileError& error)
  {
    this->Refuse(error.what());
    return 1;
  }
  const tetmarch::ImageHeader& header = *this->Header->Header;
  const auto& [nx, ny, nz] = header.Dimensions;
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 0, nx - 1, 0, ny - 1, 0, nz - 1);
  information->Set(vtkDataObject::SPACING(), header.Spacing.data(), 3);
  information->Set(vtkDataObject::ORIGIN(), header.Origin.data(), 3);
  information->Set(vtkDataObject::DIRECTION(), header.Direction.data(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(information, header.Type, header.Components);
  return 1;
}

int vtkTetMarchImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(outputVector);
  image->Initialize();
  if (!this->Header->Header)
  {
    return 1;
  }
  const tetmarch::ImageHeader& header = *this->Header->Header;
  const auto scalars = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(header.Type));
  scalars->SetName(header.ArrayName);
  scalars->SetNumberOfComponents(header.Components);
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(tetmarch::countOf(header)) / header.Components);
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  };
  try
  {
    if (!tetmarch::readImageValues(header, scalars->GetVoidPointer(0), progress))
    {
      return 1;
    }
  }
  catch (const tetmarch::ImageFileError& error)
  {
    this->Refuse(error.what());
    return 1;
  }
  image->SetDimensions(header.Dimensions.data());
  image->SetSpacing(header.Spacing.data());
  image->SetOrigin(header.Origin.data());
  image->SetDirectionMatrix(header.Direction.data());
  image->GetPointData()->SetScalars(scalars);
  return 1;
}
