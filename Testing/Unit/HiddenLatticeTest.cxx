// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cells of a lattice ghost arrays hide, against the rule in words, cell by cell.
#include "Structured/HiddenLatticeCells.h"

#include "StructuredGrids.h"

#include "vtkDataSetAttributes.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Ghosts = vtkDataSetAttributes;
using Number = std::array<int, 3>;

bool isHidden(const std::vector<std::uint32_t>& bits, std::size_t c)
{
  return !bits.empty() && (bits[c / 32] >> c % 32 & 1u) != 0;
}

// The rule, one cell at a time.
class Rule
{
public:
  Rule(vtkDataSet* data, const Number& points)
    : Arrays(ghostArraysOf(data))
    , Points(points)
  {
  }

  bool hides(const LatticeCase& lies, const Number& cell) const
  {
    const bool linear = lies.Between == Interpolation::Linear;
    if (lies.OfCells != linear)
    {
      return this->isHiddenCell(cell); // a cell of the data
    }
    return lies.OfCells ? this->anyAround(cell, [this](const Number& c) { return isHiddenCell(c); })
                        : this->isMarkedPoint(cell) || this->allMarkedAround(cell);
  }

private:
  bool isMarkedPoint(const Number& p) const
  {
    const auto i = (vtkIdType(p[2]) * this->Points[1] + p[1]) * this->Points[0] + p[0];
    return this->Arrays.OfPoints && (this->Arrays.OfPoints->GetValue(i) & Ghosts::HIDDENPOINT) != 0;
  }
  bool isMarkedCell(const Number& c) const
  {
    const auto i = (vtkIdType(c[2]) * (this->Points[1] - 1) + c[1]) * (this->Points[0] - 1) + c[0];
    return this->Arrays.OfCells &&
           (this->Arrays.OfCells->GetValue(i) &
             (Ghosts::HIDDENCELL | Ghosts::DUPLICATECELL | Ghosts::REFINEDCELL)) != 0;
  }
  bool isHiddenCell(const Number& c) const
  {
    bool hidden = this->isMarkedCell(c);
    for (int corner = 0; corner < 8; ++corner)
    {
      hidden =
        hidden || this->isMarkedPoint(
                    { { c[0] + (corner & 1), c[1] + (corner >> 1 & 1), c[2] + (corner >> 2) } });
    }
    return hidden;
  }
  // Of the data's cells before and behind a number along each axis.
  template <typename Is>
  bool anyAround(const Number& at, const Is& is) const
  {
    bool any = false;
    for (int corner = 0; corner < 8; ++corner)
    {
      Number c;
      bool exists = true;
      for (int a = 0; a < 3; ++a)
      {
        c[a] = at[a] - (corner >> a & 1);
        exists = exists && c[a] >= 0 && c[a] < this->Points[a] - 1;
      }
      any = any || (exists && is(c));
    }
    return any;
  }
  bool allMarkedAround(const Number& at) const
  {
    return !this->anyAround(at, [this](const Number& c) { return !this->isMarkedCell(c); });
  }

  GhostArrays Arrays;
  Number Points;
};

int expectRule(vtkDataSet* data, const Number& points, const LatticeCase& lies)
{
  const auto bits = hiddenLatticeCells(ghostArraysOf(data), points, lies);
  const Lattice lattice = latticeOf(data, lies);
  const Rule rule(data, points);
  EXPECT_TRUE(bits.empty() || bits.size() == (lattice.numberOfCells() + 31) / 32);
  int count = 0;
  std::size_t c = 0;
  for (int k = 0; k < lattice.Axes[2].Cells; ++k)
  {
    for (int j = 0; j < lattice.Axes[1].Cells; ++j)
    {
      for (int i = 0; i < lattice.Axes[0].Cells; ++i, ++c)
      {
        const bool expected = rule.hides(lies, { { i, j, k } });
        EXPECT_EQ(isHidden(bits, c), expected) << i << " " << j << " " << k;
        count += expected ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(bits.empty(), count == 0);
  return count;
}

TEST(HiddenLatticeCells, AgainstTheRule)
{
  std::mt19937 random(5);
  std::array<int, 4> hidden{};
  for (int n = 0; n < 100; ++n)
  {
    Number points;
    for (int& p : points)
    {
      p = 2 + static_cast<int>(random() % 9);
    }
    const Image image = imageOf(points[0], points[1], points[2]);
    const auto mark = [&](vtkUnsignedCharArray* ghosts, unsigned one)
    {
      for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
      {
        ghosts->SetValue(
          i, random() % one == 0 ? static_cast<unsigned char>(1u << random() % 8) : 0);
      }
    };
    if (n % 3 != 0)
    {
      mark(image->AllocateCellGhostArray(), n % 2 == 0 ? 1 : 12);
    }
    if (n % 3 != 1)
    {
      mark(image->AllocatePointGhostArray(), 20);
    }
    for (std::size_t l = 0; l < latticeCases().size(); ++l)
    {
      SCOPED_TRACE(nameOf(latticeCases()[l]));
      hidden[l] += expectRule(image, points, latticeCases()[l]);
    }
  }
  for (const int count : hidden)
  {
    EXPECT_GT(count, 100);
  }
}

TEST(HiddenLatticeCells, WithoutMarksThereAreNone)
{
  const Image image = imageOf(4, 5, 6);
  for (const LatticeCase& lies : latticeCases())
  {
    EXPECT_TRUE(hiddenLatticeCells(ghostArraysOf(image), { { 4, 5, 6 } }, lies).empty());
  }
  image->AllocateCellGhostArray()->FillValue(Ghosts::EXTERIORCELL | Ghosts::HIGHCONNECTIVITYCELL);
  image->AllocatePointGhostArray()->FillValue(Ghosts::DUPLICATEPOINT);
  for (const LatticeCase& lies : latticeCases())
  {
    EXPECT_TRUE(hiddenLatticeCells(ghostArraysOf(image), { { 4, 5, 6 } }, lies).empty());
  }
}

// As vtkUniformGrid says which of its cells and points are visible.
TEST(HiddenLatticeCells, ByTheBlankingOfUniformGrids)
{
  const auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetDimensions(5, 6, 7);
  grid->BlankCell(5);
  grid->BlankCell(77);
  grid->BlankPoint(102);
  const LatticeCase ofData{ true, Interpolation::Nearest };
  const auto bits = hiddenLatticeCells(ghostArraysOf(grid), { { 5, 6, 7 } }, ofData);
  int hidden = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(isHidden(bits, c), grid->IsCellVisible(c) == 0) << c;
    hidden += isHidden(bits, c) ? 1 : 0;
  }
  EXPECT_EQ(hidden, 10);
  const LatticeCase ofPoints{ false, Interpolation::Nearest };
  const auto points = hiddenLatticeCells(ghostArraysOf(grid), { { 5, 6, 7 } }, ofPoints);
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    // Cells around them are blanked only in part.
    EXPECT_EQ(isHidden(points, p), grid->IsPointVisible(p) == 0) << p;
  }
}

TEST(HiddenLatticeCells, ArraysThatDontFitHideNothing)
{
  const Image image = imageOf(3, 3, 3);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(Ghosts::GhostArrayName());
  ghosts->SetNumberOfTuples(7);
  ghosts->FillValue(Ghosts::HIDDENCELL);
  image->GetCellData()->AddArray(ghosts);
  EXPECT_EQ(ghostArraysOf(image).OfCells, nullptr);
  ghosts->SetNumberOfTuples(8);
  ghosts->FillValue(Ghosts::HIDDENCELL);
  EXPECT_EQ(ghostArraysOf(image).OfCells, ghosts);
  EXPECT_EQ(
    hiddenLatticeCells(ghostArraysOf(image), { { 3, 3, 3 } }, { false, Interpolation::Linear }),
    (std::vector<std::uint32_t>{ 0xffu }));
}
} // namespace
