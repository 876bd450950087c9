// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapper.h"

#include "vtkObjectFactory.h"

class vtkTetMarchVolumeMapper::Internals
{
};

vtkStandardNewMacro(vtkTetMarchVolumeMapper);
vtkTetMarchVolumeMapper::vtkTetMarchVolumeMapper()
  : Internal(new Internals)
{
}
vtkTetMarchVolumeMapper::~vtkTetMarchVolumeMapper() = default;
void vtkTetMarchVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
void vtkTetMarchVolumeMapper::Render(vtkRenderer*, vtkVolume*) {}
void vtkTetMarchVolumeMapper::ReleaseGraphicsResources(vtkWindow*) {}
vtkIdType vtkTetMarchVolumeMapper::GetNumberOfTetrahedra() const { return 0; }
vtkIdType vtkTetMarchVolumeMapper::GetNumberOfBoundaryFaces() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetGPUMemoryBytes() const { return 0; }
double vtkTetMarchVolumeMapper::GetMeshSeconds() const { return 0; }
double vtkTetMarchVolumeMapper::GetScalarsSeconds() const { return 0; }
double vtkTetMarchVolumeMapper::GetTablesSeconds() const { return 0; }
double vtkTetMarchVolumeMapper::GetUploadSeconds() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetMeshBuilds() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetScalarsBuilds() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetTablesBuilds() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetUploadedBytes() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfRays() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfCrossedCells() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfEvaluations() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfRefusedEntries() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfLostRays() const { return 0; }
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfGuardHits() const { return 0; }
