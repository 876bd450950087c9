// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn, and how: as the command line says, the rest as vtkTetMarchFirstPicture chooses.
 */
#ifndef tetmarch_Choice_h
#define tetmarch_Choice_h

#include "CommandLine.h"
#include "VolumeData.h"

#include "vtkSmartPointer.h"
#include "vtkTetMarchFirstPicture.h"

namespace tetmarch
{

/// Throws Failure if there is no such array, or a preset can't be read.
vtkSmartPointer<vtkTetMarchFirstPicture> MakeChoice(
  const VolumeData& data, const CommandLine& commandLine);

} // namespace tetmarch

#endif
