// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of a MetaImage file, attached to its values (.mha) or detached (.mhd).
#ifndef TetMarchImageFilesMetaImageHeader_h
#define TetMarchImageFilesMetaImageHeader_h

#include "ImageFiles/ImageHeader.h"

namespace tetmarch
{

/** Throws ImageFileError. */
ImageHeader readMetaImageHeader(const std::string& path);

} // namespace tetmarch

#endif
