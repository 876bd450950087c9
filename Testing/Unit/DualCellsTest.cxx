// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells between the centres of leaves fill these once, for any differences of level.
#include "Leaves/DualCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <random>
#include <set>
#include <string>

namespace
{
using namespace tetmarch;

// Trees of leaves that are divided at random.
struct LeafCase
{
  const char* Name;
  int Levels;
  double Divided;   // share of the leaves of each level but the first, in which it is 0.7
  int Branches = 2; // along an axis
  bool Stretched = false;
  double Hidden = 0;    // share
  bool OneDeep = false; // only the leaf below the middle is divided, to the last level
};

void PrintTo(const LeafCase& leafCase, std::ostream* os) { *os << leafCase.Name; }

class RandomLeaves
{
public:
  explicit RandomLeaves(const LeafCase& leafCase)
    : Made(leafCase)
  {
    int width = 1;
    for (int level = 1; level < leafCase.Levels; ++level)
    {
      width *= leafCase.Branches;
    }
    for (LeafAxis& axis : this->Tree.Axes)
    {
      axis.CellsBetweenBreaks = width;
      axis.Breaks = { -0.5 };
      for (int i = 0; i < Roots; ++i)
      {
        const double step = leafCase.Stretched ? 0.02 + std::pow(this->share(), 3) : 1;
        axis.Breaks.push_back(axis.Breaks.back() + step);
      }
    }
    for (int root = 0; root < Roots * Roots * Roots; ++root)
    {
      const LeafPlace at{ { root % Roots, root / Roots % Roots, root / (Roots * Roots) } };
      this->divide(
        { { { at[0] * width, at[1] * width, at[2] * width } }, { { width, width, width } } }, 0);
    }
    this->Tree.Shown = this->Tree.All.size();
    this->Tree.All.insert(this->Tree.All.end(), this->Away.begin(), this->Away.end());
  }

  static constexpr int Roots = 4;
  Leaves Tree;

private:
  double share() { return static_cast<double>(this->Random()) / 4294967296.0; }

  bool isDivided(const Leaf& leaf, int level)
  {
    if (level + 1 == this->Made.Levels)
    {
      return false;
    }
    return this->Made.OneDeep ? this->holdsMiddle(leaf)
                              : this->share() < (level == 0 ? 0.7 : this->Made.Divided);
  }

  // Whether the lowest octant around the middle of the mesh begins in the leaf.
  bool holdsMiddle(const Leaf& leaf) const
  {
    const int middle = Roots / 2 * this->Tree.Axes[0].CellsBetweenBreaks;
    return std::all_of(leaf.Low.begin(), leaf.Low.end(),
      [&](int low) { return low < middle && low + leaf.Size[0] >= middle; });
  }

  void divide(const Leaf& leaf, int level)
  {
    if (!this->isDivided(leaf, level))
    {
      (this->share() < this->Made.Hidden ? this->Away : this->Tree.All).push_back(leaf);
      return;
    }
    const int n = this->Made.Branches;
    for (int child = 0; child < n * n * n; ++child)
    {
      Leaf part;
      const LeafPlace at{ { child % n, child / n % n, child / (n * n) } };
      for (int a = 0; a < 3; ++a)
      {
        part.Size[a] = leaf.Size[a] / n;
        part.Low[a] = leaf.Low[a] + at[a] * part.Size[a];
      }
      this->divide(part, level + 1);
    }
  }

  LeafCase Made;
  std::mt19937 Random{ 1 };
  std::vector<Leaf> Away;
};

class DualCellsOf : public ::testing::TestWithParam<LeafCase>
{
};

TEST_P(DualCellsOf, CornersKnowTheLeavesAroundThem)
{
  const Leaves leaves = RandomLeaves(GetParam()).Tree;
  const int n = RandomLeaves::Roots * leaves.Axes[0].CellsBetweenBreaks;
  std::vector<int> owners(static_cast<std::size_t>(n) * n * n, NoLeaf);
  std::set<LeafPlace> expected;
  for (std::size_t l = 0; l < leaves.All.size(); ++l)
  {
    const Leaf& leaf = leaves.All[l];
    const int width = leaf.Size[0];
    for (int i = 0; i < width * width * width; ++i)
    {
      const int x = leaf.Low[0] + i % width;
      const int y = leaf.Low[1] + i / width % width;
      owners[x + n * (y + n * (leaf.Low[2] + i / (width * width)))] = static_cast<int>(l);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      expected.insert({ { leaf.Low[0] + (corner & 1) * width,
        leaf.Low[1] + (corner >> 1 & 1) * width, leaf.Low[2] + (corner >> 2) * width } });
    }
  }
  std::set<LeafPlace> found;
  for (const LeafCorner& corner : cornersOf(leaves.All))
  {
    EXPECT_TRUE(found.insert(corner.At).second);
    for (int octant = 0; octant < 8; ++octant)
    {
      const int x = corner.At[0] - 1 + (octant & 1);
      const int y = corner.At[1] - 1 + (octant >> 1 & 1);
      const int z = corner.At[2] - 1 + (octant >> 2);
      const bool inside = std::min({ x, y, z }) >= 0 && std::max({ x, y, z }) < n;
      ASSERT_EQ(corner.Around[octant], inside ? owners[x + n * (y + n * z)] : NoLeaf);
    }
  }
  EXPECT_EQ(found, expected);
}

// The cells as tetrahedra, rectangles cut by either diagonal.
class CutCells
{
public:
  CutCells(const Leaves& leaves, const DualCells& cells)
    : From(leaves)
    , Cells(cells)
  {
    constexpr int inBox[6][4] = { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 },
      { 0, 4, 5, 6 }, { 0, 5, 1, 6 } };
    for (const auto& box : cells.Boxes)
    {
      for (const auto& tet : inBox)
      {
        this->add(box[tet[0]], box[tet[1]], box[tet[2]], box[tet[3]]);
      }
    }
    for (const auto& pyramid : cells.Pyramids)
    {
      this->add(pyramid[0], pyramid[1], pyramid[2], pyramid[4]);
      this->add(pyramid[0], pyramid[2], pyramid[3], pyramid[4]);
    }
    for (const auto& tet : cells.Tetrahedra)
    {
      this->add(tet[0], tet[1], tet[2], tet[3]);
    }
  }

  Vector3 at(int point) const
  {
    const int shown = static_cast<int>(this->From.Shown);
    return point < shown ? this->From.center(point) : this->Cells.Mixed[point - shown].Position;
  }

  double Volume = 0;
  double Least = 1; // of six times a volume

private:
  void add(int a, int b, int c, int d)
  {
    const Vector3 o = this->at(a);
    const double six = dot(cross(this->at(b) - o, this->at(c) - o), this->at(d) - o);
    this->Volume += six / 6;
    this->Least = std::min(this->Least, six);
  }

  const Leaves& From;
  const DualCells& Cells;
};

TEST_P(DualCellsOf, FillTheLeavesOnce)
{
  const Leaves leaves = RandomLeaves(GetParam()).Tree;
  const DualCells cells = dualCellsOf(leaves, cornersOf(leaves.All));
  double expected = 0;
  for (int leaf = 0; leaves.isShown(leaf); ++leaf)
  {
    double volume = 1;
    for (int a = 0; a < 3; ++a)
    {
      volume *= leaves.high(leaf, a) - leaves.low(leaf, a);
    }
    expected += volume;
  }
  const CutCells cut(leaves, cells);
  EXPECT_GT(cut.Least, 0);
  EXPECT_NEAR(cut.Volume, expected, 1e-12 * expected);
}

TEST_P(DualCellsOf, MeetAtWholeFaces)
{
  const LeafCase& leafCase = GetParam();
  const Leaves leaves = RandomLeaves(leafCase).Tree;
  const DualCells cells = dualCellsOf(leaves, cornersOf(leaves.All));
  std::map<std::vector<int>, int> faces;
  const auto add = [&](std::vector<int> face)
  {
    std::sort(face.begin(), face.end());
    ++faces[face];
  };
  for (const auto& b : cells.Boxes)
  {
    for (int k = 0; k < 4; ++k)
    {
      add({ b[k], b[(k + 1) % 4], b[4 + (k + 1) % 4], b[4 + k] });
    }
    add({ b[0], b[1], b[2], b[3] });
    add({ b[4], b[5], b[6], b[7] });
  }
  for (const auto& p : cells.Pyramids)
  {
    add({ p[0], p[1], p[2], p[3] });
    for (int k = 0; k < 4; ++k)
    {
      add({ p[k], p[(k + 1) % 4], p[4] });
    }
  }
  for (const auto& t : cells.Tetrahedra)
  {
    for (int k = 0; k < 4; ++k)
    {
      add({ t[k], t[(k + 1) % 4], t[(k + 2) % 4] });
    }
  }
  const CutCells cut(leaves, cells);
  const auto isOnBorder = [&](const std::vector<int>& face)
  {
    bool border = false;
    for (int a = 0; a < 3; ++a)
    {
      for (const double plane : { leaves.Axes[a].Breaks.front(), leaves.Axes[a].Breaks.back() })
      {
        border = border || std::all_of(face.begin(), face.end(),
                             [&](int point) { return cut.at(point)[a] == plane; });
      }
    }
    return border;
  };
  for (const auto& [face, count] : faces)
  {
    ASSERT_LE(count, 2);
    if (count == 1 && leafCase.Hidden == 0)
    {
      ASSERT_TRUE(isOnBorder(face));
    }
  }
}

// Values between leaves are between theirs; where levels of neighbours differ by at most one, a
// linear function is the same everywhere inside.
TEST_P(DualCellsOf, ValuesAreLinear)
{
  const LeafCase& leafCase = GetParam();
  const Leaves leaves = RandomLeaves(leafCase).Tree;
  const DualCells cells = dualCellsOf(leaves, cornersOf(leaves.All));
  const auto linear = [](const Vector3& p) { return 1 + 2 * p[0] - 3 * p[1] + 0.5 * p[2]; };
  const bool exact =
    leafCase.Levels <= 2 && !leafCase.Stretched && leafCase.Branches == 2 && leafCase.Hidden == 0;
  for (const MixedPoint& point : cells.Mixed)
  {
    double value = 0;
    double sum = 0;
    for (std::size_t i = 0; i < point.From.size(); ++i)
    {
      ASSERT_GE(point.Weights[i], 0);
      ASSERT_TRUE(leaves.isShown(point.From[i]));
      sum += point.Weights[i];
      value += point.Weights[i] * linear(leaves.center(point.From[i]));
    }
    ASSERT_NEAR(sum, 1, 1e-12);
    const bool inside = std::all_of(point.Position.begin(), point.Position.end(),
      [&](double x) { return x > 0 && x < RandomLeaves::Roots - 1; });
    if (exact && inside)
    {
      ASSERT_NEAR(value, linear(point.Position), 1e-8);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, DualCellsOf,
  ::testing::Values(LeafCase{ "Even", 1, 0 }, LeafCase{ "OneLevelApart", 2, 0 },
    LeafCase{ "TwoLevelsApart", 3, 0.4 }, LeafCase{ "FourLevelsApart", 5, 0.25 },
    LeafCase{ "FourLevelsAtACorner", 5, 0, 2, false, 0, true },
    LeafCase{ "ThreeBranches", 3, 0.1, 3 }, LeafCase{ "Stretched", 4, 0.3, 2, true },
    LeafCase{ "Hidden", 4, 0.3, 2, false, 0.1 }),
  [](const auto& each) { return std::string(each.param.Name); });

TEST(DualCells, EqualLeavesGiveBoxes)
{
  const Leaves leaves = RandomLeaves({ "Even", 1, 0 }).Tree;
  const DualCells cells = dualCellsOf(leaves, cornersOf(leaves.All));
  EXPECT_EQ(cells.Boxes.size(), 27u);
  EXPECT_EQ(cells.Pyramids.size(), 54u); // at each rectangle at the border
}
} // namespace
