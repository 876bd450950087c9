// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Detection of a libexpat with which VTK loses appended data of XML files.
// Since 2.6.0, and in Debian's patched older versions, libexpat defers parsing of a tag that
// arrives in pieces. vtkXMLDataParser of VTK 9.2 relies on each piece being parsed at once:
// otherwise it continues into the binary data behind the tag. Readers then have no cells, and
// processes lose cells that they exchange. Plugin/Expat is the remedy.
#ifndef TetMarchAppendedData_h
#define TetMarchAppendedData_h

#include "vtkTetMarchRepresentationModule.h"

#include <string>

namespace tetmarch
{

/**
 * Whether the XML parser of this process finds appended data, tested with a small document.
 */
VTKTETMARCHREPRESENTATION_EXPORT bool findsAppendedData();

/**
 * The remedy for users if it doesn't: an imperative sentence without its full stop.
 */
std::string remedyForAppendedData();

/**
 * Warns with the remedy if it doesn't, once in the first process.
 */
VTKTETMARCHREPRESENTATION_EXPORT void warnIfAppendedDataIsLost();

} // namespace tetmarch

#endif
