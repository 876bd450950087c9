// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An image in blocks, beside the whole of it
 */
#ifndef tetmarch_testing_SmartBlocks_h
#define tetmarch_testing_SmartBlocks_h

#include "SmartScene.h"

#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace tetmarch::testing
{
/// The part of the image within an extent, with its points on the borders.
inline vtkSmartPointer<vtkImageData> partOf(vtkImageData* image, const std::array<int, 6>& extent)
{
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->SetOrigin(image->GetOrigin());
  part->SetSpacing(image->GetSpacing());
  part->SetExtent(const_cast<int*>(extent.data()));
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  vtkDataArray* all = image->GetPointData()->GetArray("f");
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        int ijk[3] = { i, j, k };
        values->InsertNextValue(all->GetComponent(image->ComputePointId(ijk), 0));
      }
    }
  }
  part->GetPointData()->SetScalars(values);
  return part;
}

/// Parts between planes across each axis, all but one in a tree of their own.
inline vtkSmartPointer<vtkMultiBlockDataSet> inBlocks(
  vtkImageData* image, const std::array<std::vector<int>, 3>& planes)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> others;
  tree->SetBlock(0, others);
  unsigned int count = 0;
  for (std::size_t k = 0; k + 1 < planes[2].size(); ++k)
  {
    for (std::size_t j = 0; j + 1 < planes[1].size(); ++j)
    {
      for (std::size_t i = 0; i + 1 < planes[0].size(); ++i)
      {
        const auto part = partOf(image, { { planes[0][i], planes[0][i + 1], planes[1][j],
                                          planes[1][j + 1], planes[2][k], planes[2][k + 1] } });
        count == 0 ? tree->SetBlock(1, part) : others->SetBlock(count, part);
        ++count;
      }
    }
  }
  return tree;
}

constexpr int Cells = 12; // along each edge of the whole

/// Where an image is cut: numbers of points along each axis, the ends among them.
struct Cut
{
  const char* Name;
  std::array<std::vector<int>, 3> Planes;
};
inline const Cut Cuts[] = {
  { "Halves", { { { 0, 7, Cells }, { 0, Cells }, { 0, Cells } } } },
  { "Eighths", { { { 0, 5, Cells }, { 0, 8, Cells }, { 0, 3, Cells } } } },
  { "ThirtySix", { { { 0, 1, 6, Cells }, { 0, 4, 10, Cells }, { 0, 3, 6, 9, Cells } } } },
};

class SmartBlocks : public ::testing::Test
{
protected:
  static constexpr int Side = 96;

  Image inParts(const std::array<std::vector<int>, 3>& planes)
  {
    this->Shown.Mapper->SetInputDataObject(inBlocks(this->Whole, planes));
    const Image parts = this->Shown.frame();
    this->Shown.Mapper->SetInputDataObject(this->Whole);
    return parts;
  }
  vtkCamera* camera() { return this->Shown.Renderer->GetActiveCamera(); }

  vtkSmartPointer<vtkImageData> Whole = imageOf(sineField(), unitCube(Cells));
  SmartScene Shown{ Whole, Side, Side };
};
} // namespace tetmarch::testing

#endif
