// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties that a vtkTetMarchVolumeRepresentation sets at its mapper and its vtkVolumeProperty.
#include "vtkTetMarchVolumeRepresentation.h"

#include "vtkContourValues.h"
#include "vtkTetMarchLastFrame.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolumeProperty.h"

vtkTetMarchSettings* vtkTetMarchVolumeRepresentation::GetSettings() const
{
  return this->TetMarchMapper->GetSettings();
}

void vtkTetMarchVolumeRepresentation::SetLastFrame(vtkTetMarchLastFrame* frame)
{
  frame->Follow(this->TetMarchMapper, this->TetMarchMapper->GetLastFrameStatistics());
}

void vtkTetMarchVolumeRepresentation::SetBlendMode(int mode)
{
  this->TetMarchMapper->SetBlendMode(mode);
}

void vtkTetMarchVolumeRepresentation::SetAverageIPScalarRange(double low, double high)
{
  this->TetMarchMapper->SetAverageIPScalarRange(low, high);
}

void vtkTetMarchVolumeRepresentation::SetCropping(bool cropping)
{
  this->TetMarchMapper->SetCropping(cropping);
}

void vtkTetMarchVolumeRepresentation::SetCroppingRegionFlags(int flags)
{
  this->TetMarchMapper->SetCroppingRegionFlags(flags);
}

void vtkTetMarchVolumeRepresentation::SetShade(bool shade) { this->Property->SetShade(shade); }

void vtkTetMarchVolumeRepresentation::SetAmbient(double ambient)
{
  this->Property->SetAmbient(ambient);
}

void vtkTetMarchVolumeRepresentation::SetDiffuse(double diffuse)
{
  this->Property->SetDiffuse(diffuse);
}

void vtkTetMarchVolumeRepresentation::SetSpecular(double specular)
{
  this->Property->SetSpecular(specular);
}

void vtkTetMarchVolumeRepresentation::SetSpecularPower(double power)
{
  this->Property->SetSpecularPower(power);
}

void vtkTetMarchVolumeRepresentation::SetNumberOfIsosurfaces(int number)
{
  this->Property->GetIsoSurfaceValues()->SetNumberOfContours(number);
}

void vtkTetMarchVolumeRepresentation::SetIsosurfaceValue(int i, double value)
{
  this->Property->GetIsoSurfaceValues()->SetValue(i, value);
}
