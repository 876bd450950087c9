// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions as lists of points between which they are linear.
#ifndef TetMarchWebPageFunctionJson_h
#define TetMarchWebPageFunctionJson_h

#include "vtk_jsoncpp.h" // whose namespace has another name in ParaView

class vtkVolumeProperty;

namespace tetmarch
{

/** Of a component: "color" [[x, r, g, b], ...] sampled between low and high, "opacity" [[x, a],
 * ...] at its nodes, "nan" [r, g, b, a]. */
Json::Value functionsOf(vtkVolumeProperty* property, int component, double low, double high);

} // namespace tetmarch

#endif
