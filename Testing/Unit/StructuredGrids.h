// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Images and rectilinear grids for unit tests, and arrays on them
 */
#ifndef tetmarch_testing_StructuredGrids_h
#define tetmarch_testing_StructuredGrids_h

#include "Structured/LatticeBuilder.h"

#include "LatticeGrids.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"

#include <array>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace tetmarch::testing
{
using Image = vtkSmartPointer<vtkImageData>;
using Rectilinear = vtkSmartPointer<vtkRectilinearGrid>;

/// The four ways in which values lie in a grid.
inline const std::vector<LatticeCase>& latticeCases()
{
  static const std::vector<LatticeCase> cases{ { false, Interpolation::Linear },
    { false, Interpolation::Nearest }, { true, Interpolation::Nearest },
    { true, Interpolation::Linear } };
  return cases;
}

inline std::string nameOf(const LatticeCase& lies)
{
  return std::string(lies.OfCells ? "cells" : "points") +
         (lies.Between == Interpolation::Linear ? ", linear" : ", nearest");
}

inline Image imageOf(int nx, int ny, int nz)
{
  auto image = Image::New();
  image->SetDimensions(nx, ny, nz);
  return image;
}

inline Rectilinear rectilinearOf(const std::array<std::vector<double>, 3>& coordinates)
{
  auto grid = Rectilinear::New();
  grid->SetDimensions(static_cast<int>(coordinates[0].size()),
    static_cast<int>(coordinates[1].size()), static_cast<int>(coordinates[2].size()));
  for (int a = 0; a < 3; ++a)
  {
    vtkNew<vtkDoubleArray> array;
    for (const double x : coordinates[a])
    {
      array->InsertNextValue(x);
    }
    a == 0   ? grid->SetXCoordinates(array)
    : a == 1 ? grid->SetYCoordinates(array)
             : grid->SetZCoordinates(array);
  }
  return grid;
}

/// An array of so many tuples with random whole numbers from low to high.
inline vtkSmartPointer<vtkDataArray> randomArray(
  int type, vtkIdType tuples, int components, double low, double high, std::mt19937& random)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  const auto count = static_cast<std::uint64_t>(high - low) + 1;
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, low + static_cast<double>(random() % count));
    }
  }
  return array;
}

/// The lattice of a grid; fails the test if something is wrong with it.
inline Lattice latticeOf(vtkDataSet* data, const LatticeCase& lies)
{
  GridGeometry geometry;
  VolumeFrame frame;
  Lattice lattice;
  EXPECT_EQ(readGeometry(data, geometry), "");
  EXPECT_EQ(findFrame(geometry, frame), "");
  EXPECT_EQ(makeLattice(geometry, frame, lies, lattice), "");
  return lattice;
}
} // namespace tetmarch::testing

#endif
