// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of VTK whose data is appended to their XML, and a libexpat with which VTK loses that data.
//
// Since 2.6.0, and in what Debian made of older ones, libexpat puts off parsing a tag that arrives
// in pieces. vtkXMLDataParser of VTK 9.2 relies on each piece being parsed at once: otherwise it
// goes on into the binary data behind the tag. Readers then have no cells, and processes lose cells
// that they send to each other. Plugin/Expat is the remedy.
#ifndef TetMarchAppendedData_h
#define TetMarchAppendedData_h

#include "vtkTetMarchRepresentationModule.h"

#include <string>

namespace tetmarch
{

/**
 * Whether the XML parser of this process finds appended data: it reads a document of ours.
 */
VTKTETMARCHREPRESENTATION_EXPORT bool findsAppendedData();

/**
 * What its user can do where it doesn't: an imperative sentence without its full stop.
 */
std::string remedyForAppendedData();

/**
 * A warning that names the remedy, if it doesn't: once in the first of all processes.
 */
VTKTETMARCHREPRESENTATION_EXPORT void warnIfAppendedDataIsLost();

} // namespace tetmarch

#endif
