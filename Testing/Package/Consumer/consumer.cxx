// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkNew.h>
#include <vtkTetMarchVolumeMapper.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>

#include <cstdlib>

int main()
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  mapper->SetInputData(grid);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  return mapper->GetInput() == grid ? EXIT_SUCCESS : EXIT_FAILURE;
}
