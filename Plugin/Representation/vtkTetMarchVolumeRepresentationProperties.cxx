// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeRepresentation hands on to its mapper and the property of its volume.
#include "vtkTetMarchVolumeRepresentation.h"

#include "vtkContourValues.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolumeProperty.h"

void vtkTetMarchVolumeRepresentation::SetOpacityLaw(int law)
{
  this->TetMarchMapper->SetOpacityLaw(law);
}

void vtkTetMarchVolumeRepresentation::SetDrawNanCells(bool draw)
{
  this->TetMarchMapper->SetDrawNanCells(draw);
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

void vtkTetMarchVolumeRepresentation::SetViewMode(int mode)
{
  this->TetMarchMapper->SetViewMode(mode);
}

void vtkTetMarchVolumeRepresentation::SetAutomaticViewRange(bool automatic)
{
  this->TetMarchMapper->SetAutomaticViewRange(automatic);
}

void vtkTetMarchVolumeRepresentation::SetViewRange(double low, double high)
{
  this->TetMarchMapper->SetViewRange(low, high);
}

void vtkTetMarchVolumeRepresentation::SetGradientType(int type)
{
  this->TetMarchMapper->SetGradientType(type);
}

void vtkTetMarchVolumeRepresentation::SetShadowMethod(int method)
{
  this->TetMarchMapper->SetShadowMethod(method);
}

void vtkTetMarchVolumeRepresentation::SetOpaqueShadows(bool shadows)
{
  this->TetMarchMapper->SetOpaqueShadows(shadows);
}

void vtkTetMarchVolumeRepresentation::SetVolumetricScatteringBlending(double blending)
{
  this->TetMarchMapper->SetVolumetricScatteringBlending(static_cast<float>(blending));
}

void vtkTetMarchVolumeRepresentation::SetGlobalIlluminationReach(double reach)
{
  this->TetMarchMapper->SetGlobalIlluminationReach(static_cast<float>(reach));
}

void vtkTetMarchVolumeRepresentation::SetAmbientOcclusion(bool occlusion)
{
  this->TetMarchMapper->SetAmbientOcclusion(occlusion);
}

void vtkTetMarchVolumeRepresentation::SetAmbientOcclusionRadius(double radius)
{
  this->TetMarchMapper->SetAmbientOcclusionRadius(radius);
}

void vtkTetMarchVolumeRepresentation::SetAmbientOcclusionDirections(int directions)
{
  this->TetMarchMapper->SetAmbientOcclusionDirections(directions);
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

void vtkTetMarchVolumeRepresentation::SetPickOpacityThreshold(double opacity)
{
  this->TetMarchMapper->SetPickOpacityThreshold(opacity);
}

void vtkTetMarchVolumeRepresentation::SetAutoAdjustSampleDistances(bool adjust)
{
  this->TetMarchMapper->SetAutoAdjustSampleDistances(adjust);
}

void vtkTetMarchVolumeRepresentation::SetImageSampleDistance(double pixels)
{
  this->TetMarchMapper->SetImageSampleDistance(pixels);
}

void vtkTetMarchVolumeRepresentation::SetMinimumImageSampleDistance(double pixels)
{
  this->TetMarchMapper->SetMinimumImageSampleDistance(pixels);
}

void vtkTetMarchVolumeRepresentation::SetMaximumImageSampleDistance(double pixels)
{
  this->TetMarchMapper->SetMaximumImageSampleDistance(pixels);
}

void vtkTetMarchVolumeRepresentation::SetLightTimeBudget(double seconds)
{
  this->TetMarchMapper->SetLightTimeBudget(seconds);
}

void vtkTetMarchVolumeRepresentation::SetMaxMemoryInBytes(vtkIdType bytes)
{
  this->TetMarchMapper->SetMaxMemoryInBytes(bytes);
}

void vtkTetMarchVolumeRepresentation::SetNumberOfIsosurfaces(int number)
{
  this->Property->GetIsoSurfaceValues()->SetNumberOfContours(number);
}

void vtkTetMarchVolumeRepresentation::SetIsosurfaceValue(int i, double value)
{
  this->Property->GetIsoSurfaceValues()->SetValue(i, value);
}
