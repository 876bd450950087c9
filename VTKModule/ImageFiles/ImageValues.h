// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The values of an image file.
#ifndef TetMarchImageFilesImageValues_h
#define TetMarchImageFilesImageValues_h

#include "ImageFiles/ImageHeader.h"

#include <functional>

namespace tetmarch
{

/** Checks that the files exist and are long enough, before memory is allocated for their values.
 * Throws ImageFileError. */
void checkImageFiles(const ImageHeader& header);

/** Called with the share that was read, from 0 to 1; returns whether to continue. */
using ImageProgress = std::function<bool(double)>;

/** Reads bytesOf(header) bytes of checked files. Throws ImageFileError. Returns false if it was
 * stopped. */
bool readImageValues(const ImageHeader& header, void* values, const ImageProgress& progress);

} // namespace tetmarch

#endif
