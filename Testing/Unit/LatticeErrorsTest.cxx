// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Data that makes no lattice is refused with what is wrong and what to do.
#include "StructuredGrids.h"

#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <cmath>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

std::string errorOf(vtkDataSet* data, const LatticeCase& lies = {})
{
  GridGeometry geometry;
  VolumeFrame frame;
  Lattice lattice;
  std::string error = readGeometry(data, geometry);
  error = error.empty() ? findFrame(geometry, frame) : error;
  return error.empty() ? makeLattice(geometry, frame, lies, lattice) : error;
}

void expectWords(const std::string& error, const std::vector<const char*>& words)
{
  for (const char* word : words)
  {
    EXPECT_NE(error.find(word), std::string::npos) << "\"" << word << "\" in: " << error;
  }
  EXPECT_EQ(error.empty() ? '.' : error.back(), '.') << error;
}

TEST(LatticeErrors, WhatIsThinIsRefused)
{
  expectWords(errorOf(imageOf(1, 1, 9)), { "1 x 1 x 9", "at least 2", "vtkImageSlice" });
  expectWords(errorOf(imageOf(5, 1, 9)), { "5 x 1 x 9" });
  expectWords(errorOf(rectilinearOf({ { { 0, 1 }, { 0, 1 }, { 0 } } })), { "2 x 2 x 1" });
  for (const LatticeCase& lies : latticeCases())
  {
    EXPECT_EQ(errorOf(imageOf(2, 2, 2), lies), "");
  }
}

TEST(LatticeErrors, ImagesThatSpanNoVolumeAreRefused)
{
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  for (const double wrong : { 0.0, nan, inf })
  {
    const Image image = imageOf(3, 3, 3);
    image->SetSpacing(1, wrong, 1);
    expectWords(errorOf(image), { "spacing along axis 1", "finite and not 0" });
  }
  for (const double wrong : { nan, -inf })
  {
    const Image image = imageOf(3, 3, 3);
    image->SetOrigin(0, 0, wrong);
    expectWords(errorOf(image), { "origin is not finite" });
  }
  const Image flat = imageOf(3, 3, 3);
  flat->SetDirectionMatrix(1, 0, 1, 0, 1, 1, 0, 0, 0);
  expectWords(errorOf(flat), { "direction matrix is singular" });
  flat->SetDirectionMatrix(1, 0, 0, 0, nan, 0, 0, 0, 1);
  expectWords(errorOf(flat), { "direction matrix" });
  flat->SetDirectionMatrix(1, 0, 0.9, 0, 1, 0.4, 0, 0, 0.1);
  EXPECT_EQ(errorOf(flat), "");
  flat->SetSpacing(1e308, 1e308, 1e308);
  expectWords(errorOf(flat), { "larger than double precision" });
  flat->SetSpacing(1e-200, 1e-200, 1e-200);
  expectWords(errorOf(flat), { "Scale them" });
}

TEST(LatticeErrors, CoordinatesOutOfOrderAreRefused)
{
  const std::vector<double> fine{ 0, 1, 2 };
  expectWords(errorOf(rectilinearOf({ { fine, { 0, 2, 2, 3 }, fine } })),
    { "y coordinate number 2 is 2", "number 1 is 2", "sort" });
  expectWords(
    errorOf(rectilinearOf({ { fine, fine, { 5, 3, 4, 1 } } })), { "z coordinate number 2" });
  expectWords(errorOf(rectilinearOf({ { { 0, std::nan(""), 2 }, fine, fine } })),
    { "x coordinate number 1 is nan", "finite" });
  const Rectilinear thin = rectilinearOf({ { { 0, 1, 1 + 1e-9, 1000 }, fine, fine } });
  expectWords(errorOf(thin, { false, Interpolation::Linear }),
    { "x coordinates lie too close", "near number 2", "Leave out" });
  EXPECT_EQ(errorOf(thin, { false, Interpolation::Nearest }), ""); // halfway between they differ
  EXPECT_EQ(errorOf(rectilinearOf({ { { 0, 1, 1.01, 1000 }, fine, fine } })), "");
  const Rectilinear grid = rectilinearOf({ { fine, fine, fine } });
  grid->SetDimensions(3, 4, 3);
  expectWords(errorOf(grid), { "3 y coordinates", "4 points" });
  grid->SetXCoordinates(nullptr);
  grid->SetDimensions(3, 3, 3);
  expectWords(errorOf(grid), { "0 x coordinates" });
}

// 2^32 - 1 = 3 x 5 x 17 x 257 x 65537.
TEST(LatticeErrors, CellsHaveNumbersOf32Bits)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  GTEST_SKIP() << "This VTK takes all memory for the points of such an image.";
#endif
  const LatticeCase points{ false, Interpolation::Linear };
  const LatticeCase centers{ true, Interpolation::Linear };
  EXPECT_EQ(errorOf(imageOf(65538, 65536, 2), points), "");
  EXPECT_EQ(latticeOf(imageOf(65538, 65536, 2), points).numberOfCells(), 4294967295u);
  expectWords(errorOf(imageOf(65538, 65536, 2), centers), { "65538 x 65536 x 2", "4294967295" });
  expectWords(errorOf(imageOf(65537, 65537, 2), points), { "65536 x 65536 x 1", "4294967295" });
  expectWords(errorOf(imageOf(2000000000, 2000000000, 2000000000), points), { "coarsen" });
}

TEST(LatticeErrors, OtherDataIsRefusedAndNoneIsFine)
{
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  expectWords(errorOf(grid), { "vtkUnstructuredGrid is neither", "vtkTetMarchVolumeMapper" });
  GridGeometry geometry;
  EXPECT_EQ(readGeometry(nullptr, geometry), "");
  EXPECT_TRUE(geometry.isEmpty());
  EXPECT_EQ(readGeometry(Image::New(), geometry), "");
  EXPECT_TRUE(geometry.isEmpty());
  EXPECT_EQ(readGeometry(Rectilinear::New(), geometry), "");
  EXPECT_TRUE(geometry.isEmpty());
  const auto uniformGrid = vtkSmartPointer<vtkUniformGrid>::New();
  uniformGrid->SetDimensions(3, 4, 5);
  EXPECT_EQ(readGeometry(uniformGrid, geometry), "");
  EXPECT_EQ(geometry.Points, (std::array<int, 3>{ { 3, 4, 5 } }));
}
} // namespace
