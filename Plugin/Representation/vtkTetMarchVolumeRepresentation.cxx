// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeRepresentation.h"

#include "vtkObjectFactory.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolumeRepresentationPreprocessor.h"

namespace
{
// As the default of the property SelectMapper in TetMarch.xml.
constexpr const char* MapperName = "Tet marching";
} // namespace

vtkStandardNewMacro(vtkTetMarchVolumeRepresentation);

vtkTetMarchVolumeRepresentation::vtkTetMarchVolumeRepresentation()
{
  this->Preprocessor->SetTetrahedraOnly(0);
  this->AddVolumeMapper(MapperName, this->TetMarchMapper);
  this->SetActiveVolumeMapper(MapperName);
}

vtkTetMarchVolumeRepresentation::~vtkTetMarchVolumeRepresentation() = default;

void vtkTetMarchVolumeRepresentation::SetOpacityLaw(int law)
{
  this->TetMarchMapper->SetOpacityLaw(law);
}

void vtkTetMarchVolumeRepresentation::SetAccuracyLevel(int level)
{
  this->TetMarchMapper->SetAccuracyLevel(level);
}

void vtkTetMarchVolumeRepresentation::SetErrorTolerance(double tolerance)
{
  this->TetMarchMapper->SetErrorTolerance(tolerance);
}

void vtkTetMarchVolumeRepresentation::SetFrameTimeBudget(double seconds)
{
  this->TetMarchMapper->SetFrameTimeBudget(seconds);
}

void vtkTetMarchVolumeRepresentation::SetErrorBudget(double error)
{
  this->TetMarchMapper->SetErrorBudget(error);
}

void vtkTetMarchVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TetMarchMapper:\n";
  this->TetMarchMapper->PrintSelf(os, indent.GetNextIndent());
}
