// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a grid its mesh depends on, so that the same content in another grid is recognised.
#ifndef TetMarchInputGridContent_h
#define TetMarchInputGridContent_h

#include "Caching/ContentHash.h"
#include "Caching/Fingerprint.h"

#include <array>
#include <cstddef>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** Identities and times of change of the arrays that a mesh depends on: none is read. */
Fingerprint versionOf(vtkUnstructuredGrid* grid);

/** The values of these arrays. */
class GridContent
{
public:
  /** Read the content of the grid. An array with the identity and time of change of before is not
   * read again. */
  void read(vtkUnstructuredGrid* grid);

  /** Whether all values are the same; nothing was read from grids that have none. */
  bool operator==(const GridContent& other) const;
  /** All but the points. */
  bool hasCellsOf(const GridContent& other) const;

private:
  // An array with what holds it, either of which may be told that it was modified.
  struct Version
  {
    vtkObject* Owner;
    vtkDataArray* Array;
    vtkMTimeType Time;
    bool operator==(const Version& other) const
    {
      return this->Owner == other.Owner && this->Array == other.Array && this->Time == other.Time;
    }
  };
  static constexpr std::size_t NumberOfArrays = 10;
  using Versions = std::array<Version, NumberOfArrays>;
  static Versions versionsOf(vtkUnstructuredGrid* grid);
  friend Fingerprint versionOf(vtkUnstructuredGrid* grid);

  Versions Read{};
  std::array<ContentHash, NumberOfArrays> Hashes{};
};

} // namespace tetmarch

#endif
