// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The faces of polyhedra as the arrays that this version of VTK keeps them in
 */
#ifndef tetmarch_testing_RawFaces_h
#define tetmarch_testing_RawFaces_h

#include "GridBuilder.h"
#include "Input/GridVersions.h"

class vtkUnsignedCharArray;

namespace tetmarch::testing
{
/// The arrays need not fit together. Input/GridVersions.h says what they mean.
struct RawFaces
{
#if TETMARCH_FACES_ARE_STREAMS
  Ids Locations;
  Ids Streams;
#else
  Ids LocationOffsets{ 0 };
  Ids Locations;
  Ids Offsets{ 0 };
  Ids Points;
#endif

  RawFaces() = default;
  explicit RawFaces(vtkUnstructuredGrid* grid);

  /// The faces of the next cell, a polyhedron.
  void add(const std::vector<Ids>& faces);
  /// The next cell is no polyhedron.
  void addNone();

  /// All that say where faces are, and all that say what they are.
  std::vector<Ids*> locationArrays();
  std::vector<Ids*> faceArrays();

  /// Arrays of just these numbers.
  vtkSmartPointer<FaceArray> locations() const;
  vtkSmartPointer<FaceArray> faces() const;
};

/// Either of the two may be null.
void setCells(vtkUnstructuredGrid* grid, vtkDataArray* types, vtkCellArray* cells,
  FaceArray* faceLocations, FaceArray* faces);

/// An array of these numbers.
template <typename Array, typename T>
vtkSmartPointer<Array> arrayOf(const std::vector<T>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<typename Array::ValueType>(values[i]));
  }
  return array;
}

/// The numbers of an array; none if it is null.
Ids valuesOf(vtkDataArray* array);
} // namespace tetmarch::testing

#endif
