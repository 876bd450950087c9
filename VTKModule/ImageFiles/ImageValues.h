// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The values of an image file.
#ifndef TetMarchImageFilesImageValues_h
#define TetMarchImageFilesImageValues_h

#include "ImageFiles/ImageHeader.h"

#include <functional>

namespace tetmarch
{

/** Whether the files are there and long enough. Throws ImageFileError: no memory should be taken
 * for values that can't be there. */
void checkImageFiles(const ImageHeader& header);

/** Is told the share that is read, from 0 to 1; returns whether to go on. */
using ImageProgress = std::function<bool(double)>;

/** Into bytesOf(header) bytes, of checked files. Throws ImageFileError. Returns false if it was
 * told to stop. */
bool readImageValues(const ImageHeader& header, void* values, const ImageProgress& progress);

} // namespace tetmarch

#endif
