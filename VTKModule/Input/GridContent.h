// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of an unstructured or curvilinear grid on which its mesh depends, so that equal content
// in another grid is recognised.
#ifndef TetMarchInputGridContent_h
#define TetMarchInputGridContent_h

#include "Caching/ContentHash.h"
#include "Caching/Fingerprint.h"

#include <array>
#include <cstddef>

class vtkPointSet;

namespace tetmarch
{

/** Dimensions, and identities and times of change of the arrays that a mesh depends on: none is
 * read. */
Fingerprint versionOf(vtkPointSet* grid);

/** The values of these arrays. */
class GridContent
{
public:
  /** Read the content of the grid. An array with unchanged identity and time of change is not read
   * again. */
  void read(vtkPointSet* grid);

  /** Whether all values are the same and were read from a grid with values. */
  bool operator==(const GridContent& other) const;
  /** The same without the points. */
  bool hasCellsOf(const GridContent& other) const;

private:
  // The versions of an array and its holder, either of which may be modified.
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
  static Versions versionsOf(vtkPointSet* grid);
  friend Fingerprint versionOf(vtkPointSet* grid);

  Versions Read{};
  std::array<ContentHash, NumberOfArrays> Hashes{};
  std::array<int, 3> Dimensions{}; // of a curvilinear grid
};

} // namespace tetmarch

#endif
