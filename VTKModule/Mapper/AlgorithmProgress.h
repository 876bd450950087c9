// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress as the algorithms of VTK tell it, and are stopped.
#ifndef TetMarchMapperAlgorithmProgress_h
#define TetMarchMapperAlgorithmProgress_h

#include "Parallel/Progress.h"

#include "vtkAlgorithm.h"

namespace tetmarch
{

/** Invokes ProgressEvent; an observer stops the work by SetAbortExecute(). */
inline Progress beginProgressOf(vtkAlgorithm* algorithm)
{
  algorithm->SetAbortExecute(0);
  return [algorithm](double share)
  {
    algorithm->UpdateProgress(share);
    return algorithm->GetAbortExecute() == 0;
  };
}

} // namespace tetmarch

#endif
