// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchProjectedTetrahedraMapper.h"

#include "vtkTetMarchVolumeMapper.h"

#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOutputWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"

#include <algorithm>

vtkStandardNewMacro(vtkTetMarchProjectedTetrahedraMapper);

//------------------------------------------------------------------------------
vtkTetMarchProjectedTetrahedraMapper::vtkTetMarchProjectedTetrahedraMapper()
{
  for (const unsigned long event :
    { vtkCommand::ProgressEvent, vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    this->Marching->AddObserver(event, this, &vtkTetMarchProjectedTetrahedraMapper::ForwardEvent);
  }
}

//------------------------------------------------------------------------------
vtkTetMarchProjectedTetrahedraMapper::~vtkTetMarchProjectedTetrahedraMapper() = default;

//------------------------------------------------------------------------------
// Observers of this mapper get the events of the marching mapper.
void vtkTetMarchProjectedTetrahedraMapper::ForwardEvent(
  vtkObject* vtkNotUsed(from), unsigned long event, void* data)
{
  if (event == vtkCommand::ProgressEvent)
  {
    this->UpdateProgress(*static_cast<double*>(data));
  }
  else if (this->HasObserver(event))
  {
    this->InvokeEvent(event, data);
  }
  else if (event == vtkCommand::ErrorEvent)
  {
    vtkOutputWindowDisplayErrorText(static_cast<const char*>(data));
  }
  else
  {
    vtkOutputWindowDisplayWarningText(static_cast<const char*>(data));
  }
}

//------------------------------------------------------------------------------
void vtkTetMarchProjectedTetrahedraMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Marching->SetInputDataObject(this->GetInputDataObject(0, 0));
  this->Marching->SetScalarMode(this->ScalarMode);
  if (this->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
  {
    this->Marching->SelectScalarArray(this->ArrayId);
  }
  else
  {
    this->Marching->SelectScalarArray(this->ArrayName ? this->ArrayName : "");
  }
  this->Marching->SetClippingPlanes(this->ClippingPlanes);
  this->Marching->SetBlendMode(this->BlendMode);
  this->Marching->Render(renderer, volume);
  this->TimeToDraw = this->Marching->GetTimeToDraw();
}

//------------------------------------------------------------------------------
void vtkTetMarchProjectedTetrahedraMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Marching->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTetMarchProjectedTetrahedraMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Marching->GetMTime());
}

//------------------------------------------------------------------------------
bool vtkTetMarchProjectedTetrahedraMapper::IsSupported(vtkRenderWindow* window)
{
  return vtkOpenGLRenderWindow::SafeDownCast(window) != nullptr;
}

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper* vtkTetMarchProjectedTetrahedraMapper::GetMarchingMapper()
{
  return this->Marching;
}

//------------------------------------------------------------------------------
void vtkTetMarchProjectedTetrahedraMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MarchingMapper:\n";
  this->Marching->PrintSelf(os, indent.GetNextIndent());
}
