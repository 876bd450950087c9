// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the camera stands, and what of the picture the data fill.
 */
#ifndef tetmarch_Framing_h
#define tetmarch_Framing_h

#include "CommandLine.h"

class vtkCamera;
class vtkTetMarchFirstPicture;

namespace tetmarch
{

/**
 * As the command line says; what it leaves open is chosen such that all of the data is in view:
 * its silhouette, or in a series, with an outline or axes its box, which `bounds` are. A scalar
 * bar has room of its own.
 */
void PlaceCamera(const CommandLine& commandLine, vtkTetMarchFirstPicture* choice,
  const double bounds[6], vtkCamera* camera);

} // namespace tetmarch

#endif
