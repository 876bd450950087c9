// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a march draws, as the schedule of its tiles asks for it.
#ifndef TetMarchGLContentOf_h
#define TetMarchGLContentOf_h

#include "Budget/PictureContent.h"

class vtkRenderer;

namespace tetmarch
{

struct Clipping;
struct MarchInputs;

void add(Fingerprint& fingerprint, const Clipping& cut);

/** `shown` changes with data, functions and lengths (FrameStages::contentVersion()). */
PictureContent contentOf(
  const Fingerprint& shown, const MarchInputs& inputs, vtkRenderer* renderer);

} // namespace tetmarch

#endif
