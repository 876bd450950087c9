// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchSceneExporter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTetMarchSceneExporter);

void vtkTetMarchSceneExporter::WriteData()
{
  this->Superclass::WriteData();
  const std::string lacks = this->GetOmissions();
  if (!lacks.empty())
  {
    vtkWarningMacro(<< lacks);
  }
}
