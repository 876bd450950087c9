// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A bounding volume hierarchy of the boundary faces, in which rays look for entries.
#ifndef TetMarchMeshBoundaryHierarchy_h
#define TetMarchMeshBoundaryHierarchy_h

#include "TetMesh.h"

namespace tetmarch
{

/** Node and face numbers are exact in float up to here. */
constexpr std::size_t MostHierarchyFaces = std::size_t(1) << 23;

/**
 * Build Hierarchy top-down with binned surface area heuristic (Wald 2007), and bring BoundaryFaces into the
 * order of its leaves. Links must be set again afterwards.
 */
void buildHierarchy(TetMesh& mesh);

} // namespace tetmarch

#endif
