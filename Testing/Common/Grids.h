// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All the generators of grids for tests
 *
 * Every one of them gives the same grid on every platform (std::mt19937 and no distribution of the
 * standard library), with double points, active point scalars "f" and active cell scalars "c"
 * (Fields.h).
 */
#ifndef tetmarch_testing_Grids_h
#define tetmarch_testing_Grids_h

#include "CellTypeGrids.h"    // IWYU pragma: export
#include "DefectGrids.h"      // IWYU pragma: export
#include "Fields.h"           // IWYU pragma: export
#include "GridTransforms.h"   // IWYU pragma: export
#include "LatticeGrids.h"     // IWYU pragma: export
#include "NonConvexGrids.h"   // IWYU pragma: export
#include "NonManifoldGrids.h" // IWYU pragma: export
#include "PointMap.h"         // IWYU pragma: export
#include "QuadraticGrids.h"   // IWYU pragma: export
#include "ReentrantGrids.h"   // IWYU pragma: export
#include "SliverGrids.h"      // IWYU pragma: export
#include "SmallGrids.h"       // IWYU pragma: export

#endif
