// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Small files of the kinds of data that the window opens, for its pictures and tests. Each returns
 * the path of what is to be opened.
 */
#ifndef tetmarch_WriteKinds_h
#define tetmarch_WriteKinds_h

#include <QString>

namespace tetmarch
{

/// A ring of hexahedra, wedges, pyramids and tetrahedra.
QString WriteMixedCells(const QString& folder);
/// A ring of hexahedra with scalars of its cells.
QString WriteCellScalars(const QString& folder);
/// An image and an unstructured grid beside it.
QString WriteBlocks(const QString& folder);
/// Leaves of a tree of four levels.
QString WriteTree(const QString& folder);
/// Five time steps of waves in a ring, listed in a .pvd.
QString WriteTimeSeries(const QString& folder);

} // namespace tetmarch

#endif
