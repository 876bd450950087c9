// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchLastFrame.h"

#include "vtkAbstractMapper.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTetMarchLastFrame);

vtkTetMarchLastFrame::vtkTetMarchLastFrame()
  : Statistics(vtkSmartPointer<vtkTetMarchFrameStatistics>::New())
{
}

vtkTetMarchLastFrame::~vtkTetMarchLastFrame() = default;

void vtkTetMarchLastFrame::Follow(vtkAbstractMapper* mapper, vtkTetMarchFrameStatistics* statistics)
{
  this->Mapper = mapper;
  this->Statistics = statistics;
}

vtkTetMarchFrameStatistics* vtkTetMarchLastFrame::GetLastFrameStatistics() const
{
  return this->Statistics;
}

double vtkTetMarchLastFrame::GetTimeToDraw() const
{
  return this->Mapper ? this->Mapper->GetTimeToDraw() : 0.0;
}

void vtkTetMarchLastFrame::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeToDraw: " << this->GetTimeToDraw() << "\n";
  os << indent << "Statistics:\n";
  this->Statistics->PrintSelf(os, indent.GetNextIndent());
}
