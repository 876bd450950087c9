// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_TransferFunctions_h
#define tetmarch_TransferFunctions_h

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

namespace tetmarch
{

struct TransferFunctions
{
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  bool HasOpacityOfItsOwn =
    true; ///< false if a preset has colours alone and its opacity is made up
};

} // namespace tetmarch

#endif
