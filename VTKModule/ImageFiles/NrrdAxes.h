// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The axes of an NRRD file: spatial axes and the positions of their values.
#ifndef TetMarchImageFilesNrrdAxes_h
#define TetMarchImageFilesNrrdAxes_h

#include "ImageFiles/ImageHeader.h"
#include "ImageFiles/NrrdFields.h"

namespace tetmarch
{

/** Sets dimensions, components and all of the geometry. Throws ImageFileError. */
void setNrrdAxes(const NrrdFields& fields, ImageHeader& header);

} // namespace tetmarch

#endif
