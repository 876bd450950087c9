// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene as the page reads it: Web/README.md describes the members.
#ifndef TetMarchWebPageSceneJson_h
#define TetMarchWebPageSceneJson_h

#include "Mapper/CaptureScope.h"
#include "WebPage/PageArrays.h"
#include "WebPage/SceneSurfaces.h"

#include "vtk_jsoncpp.h" // whose namespace has another name in ParaView

#include <list>
#include <string>
#include <vector>

class vtkRenderer;

namespace tetmarch
{

/** The members of the scene that don't change with time: background, camera, size. */
void addView(vtkRenderer* renderer, Json::Value& scene);

/** A step in time: its volumes and surfaces. Their arrays are added to `arrays`. */
Json::Value stepOf(const std::string& label, const std::list<CaptureScope::Captured>& volumes,
  const std::vector<Surface>& surfaces, PageArrays& arrays);

/** The rows of the arrays. */
Json::Value rowsOf(const PageArrays& arrays);

/** Text of a script element: no tag can end it. */
std::string textOf(const Json::Value& value);

} // namespace tetmarch

#endif
