// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of an NRRD file (NRRD0001 to NRRD0005), attached to its values (.nrrd) or detached
// (.nhdr).
#ifndef TetMarchImageFilesNrrdHeader_h
#define TetMarchImageFilesNrrdHeader_h

#include "ImageFiles/ImageHeader.h"

namespace tetmarch
{

/** Throws ImageFileError. */
ImageHeader readNrrdHeader(const std::string& path);

} // namespace tetmarch

#endif
