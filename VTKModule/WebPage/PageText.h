// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The text of a page: the files of Web/, which CMake has put together, with a scene.
#ifndef TetMarchWebPagePageText_h
#define TetMarchWebPagePageText_h

#include "WebPage/PageArrays.h"

#include "vtk_jsoncpp.h" // whose namespace has another name in ParaView

#include <ostream>
#include <string>

namespace tetmarch
{

/** Complete the scene by what is the same in all pages, and write the page. The arrays are complete
 * but for the shaders, which are added. */
void writePage(
  const std::string& title, Json::Value& scene, PageArrays& arrays, std::ostream& stream);

} // namespace tetmarch

#endif
