// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is picked in the other blend modes than composite, in closed form: a field that is linear in
// the unit cube, of the same opacity everywhere.
#include "PickScene.h"

#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <functional>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr double Opacity = 0.6;

// The part of a pixel's ray in the cube, and the scalars at its ends.
struct Chord
{
  Vec3 Begin, End;
  double First, Last;
};

class PickedModes : public testing::Test
{
protected:
  PickedModes()
  {
    setPlainFunctions(this->Shown.property(), { { 1.0, 0.8, 0.6 } }, Opacity);
    this->Shown.Window->Render();
  }

  Chord chordOf(int x, int y)
  {
    const PickScene::PixelLine line = this->Shown.lineOf(x, y);
    double begin = 0.0, end = 100.0;
    for (int a = 0; a < 3; ++a)
    {
      const double t0 = -line.Near[a] / line.Direction[a];
      const double t1 = (1.0 - line.Near[a]) / line.Direction[a];
      begin = std::max(begin, std::min(t0, t1));
      end = std::min(end, std::max(t0, t1));
    }
    const Vec3 p = line.at(begin), q = line.at(std::max(begin, end));
    const Field field = linearField();
    return { p, q, field(p[0], p[1], p[2]), field(q[0], q[1], q[2]) };
  }

  // shareOf: the share of a chord at which it is picked; below 0: it isn't, NaN: rounding decides.
  void expectPicks(const char* what, const std::function<double(const Chord&)>& shareOf)
  {
    int hits = 0;
    double worst = 0.0, worstScalar = 0.0;
    for (int y = 6; y < SceneSize; y += 12)
    {
      for (int x = 3; x < SceneSize; x += 12)
      {
        const Chord chord = this->chordOf(x, y);
        const double length = std::hypot(chord.End[0] - chord.Begin[0],
          chord.End[1] - chord.Begin[1], chord.End[2] - chord.Begin[2]);
        const bool grazes = length > 0.0 && length < 0.05;
        const bool hardlyChanges = std::abs(chord.Last - chord.First) < 0.02 * length;
        const double share = length > 0.0 ? shareOf(chord) : -1.0;
        if (grazes || hardlyChanges || std::isnan(share))
        {
          continue;
        }
        ASSERT_EQ(this->Shown.pick(x, y), share >= 0.0) << what << " at " << x << ", " << y;
        if (share >= 0.0)
        {
          ++hits;
          const Vec3 found = this->Shown.pickedPosition();
          for (int a = 0; a < 3; ++a)
          {
            const double expected = chord.Begin[a] + share * (chord.End[a] - chord.Begin[a]);
            worst = std::max(worst, std::abs(found[a] - expected));
          }
          worstScalar =
            std::max(worstScalar, std::abs(this->Shown.Mapper->GetPickedScalar() - chord.First -
                                           share * (chord.Last - chord.First)));
          EXPECT_GE(this->Shown.Mapper->GetPickedCellId(), 0);
        }
      }
    }
    EXPECT_GT(hits, 20) << what;
    // Scalars are known to a few roundings of float, and extremes are taken within 1e-6 of them.
    EXPECT_LE(worst, 5e-4) << what;
    EXPECT_LE(worstScalar, 1e-5) << what;
    std::cout << "[ MEASURED ] " << what << ": " << hits << " points within " << worst
              << ", scalars within " << worstScalar << '\n';
  }

  PickScene Shown{ jitteredLattice(5) };
};

TEST_F(PickedModes, ExtremesAreWhereTheyAre)
{
  for (const bool greatest : { true, false })
  {
    this->Shown.Mapper->SetBlendMode(greatest ? vtkTetMarchVolumeMapper::MAXIMUM_INTENSITY_BLEND
                                              : vtkTetMarchVolumeMapper::MINIMUM_INTENSITY_BLEND);
    this->Shown.Mapper->SetPickOpacityThreshold(0.5);
    this->expectPicks(greatest ? "maximum" : "minimum",
      [&](const Chord& c) { return (c.Last > c.First) == greatest ? 1.0 : 0.0; });
    // Fainter than what is asked for.
    this->Shown.Mapper->SetPickOpacityThreshold(0.7);
    EXPECT_TRUE(this->Shown.selectAll().empty());
  }
}

TEST_F(PickedModes, SumsAreHalvedByTheThreshold)
{
  double range[2];
  this->Shown.Data->GetPointData()->GetScalars()->GetRange(range);
  for (const int mode :
    { vtkTetMarchVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkTetMarchVolumeMapper::ADDITIVE_BLEND })
  {
    this->Shown.Mapper->SetBlendMode(mode);
    for (const double threshold : { 0.25, 0.5 })
    {
      this->Shown.Mapper->SetPickOpacityThreshold(threshold);
      this->expectPicks(this->Shown.Mapper->GetBlendModeAsString(),
        [&](const Chord& c)
        {
          // a t + b t^2 / 2 of the intensity a + b t is the share of what it is at 1.
          const double a = (c.First - range[0]) / (range[1] - range[0]);
          const double b = (c.Last - c.First) / (range[1] - range[0]);
          const double wanted = threshold * (a + 0.5 * b);
          return 2.0 * wanted / (a + std::sqrt(a * a + 2.0 * b * wanted));
        });
    }
  }
}

TEST_F(PickedModes, SurfacesAreHitWhereTheyAreOpaqueEnough)
{
  const std::vector<double> values{ 0.35, 0.5, 0.65 };
  vtkContourValues* contours = this->Shown.property()->GetIsoSurfaceValues();
  contours->SetNumberOfContours(static_cast<int>(values.size()));
  for (int i = 0; i < static_cast<int>(values.size()); ++i)
  {
    contours->SetValue(i, values[static_cast<std::size_t>(i)]);
  }
  this->Shown.Mapper->SetBlendModeToIsoSurface();
  // The opacity of one of them, and of two: 1 - 0.4^2.
  for (const int surfaces : { 1, 2 })
  {
    this->Shown.Mapper->SetPickOpacityThreshold(surfaces == 1 ? Opacity : 0.8);
    this->expectPicks(surfaces == 1 ? "first surface" : "second surface",
      [&](const Chord& c)
      {
        std::vector<double> shares;
        for (const double value : values)
        {
          const double share = (value - c.First) / (c.Last - c.First);
          if (std::abs(share) < 1e-3 || std::abs(share - 1.0) < 1e-3)
          {
            return std::nan("");
          }
          if (share > 0.0 && share < 1.0)
          {
            shares.push_back(share);
          }
        }
        std::sort(shares.begin(), shares.end());
        return shares.size() < static_cast<std::size_t>(surfaces)
                 ? -1.0
                 : shares[static_cast<std::size_t>(surfaces) - 1];
      });
  }
}
} // namespace
