// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a page does not show of a renderer's actors.
#ifndef TetMarchWebPageActorOmissions_h
#define TetMarchWebPageActorOmissions_h

#include <string>
#include <vector>

class vtkMapper;
class vtkRenderer;

namespace tetmarch
{

/** Whether a mapper draws the polygons of its polydata as they are, in place of, say, glyphs. */
bool drawsPolygons(vtkMapper* mapper);

/** Adds a sentence for each kind of thing that is visible and not in the page. */
void addActorOmissions(vtkRenderer* renderer, std::vector<std::string>& omissions);

} // namespace tetmarch

#endif
