// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth of images and rectilinear grids against fine steps through VTK's own
// interpolation.
#include "LatticeImages.h"
#include "LatticeTruth.h"
#include "SelfTestModels.h"

#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

// Of the data at a point that is on no face.
double interpolated(vtkDataSet* data, const Vec3& point, LatticeValues values)
{
  vtkNew<vtkGenericCell> cell;
  double where[3];
  double weights[8];
  int part = 0;
  double at[3] = { point[0], point[1], point[2] };
  const vtkIdType id = data->FindCell(at, nullptr, cell, -1, 1e-12, part, where, weights);
  if (values == LatticeValues::CellsNearest)
  {
    return data->GetCellData()->GetScalars()->GetComponent(id, 0);
  }
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(id, corners);
  if (values == LatticeValues::PointsNearest)
  {
    const auto nearest = std::max_element(weights, weights + 8) - weights;
    return scalars->GetComponent(corners->GetId(nearest), 0);
  }
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    sum += weights[i] * scalars->GetComponent(corners->GetId(i), 0);
  }
  return sum;
}

// The values of cells as those of points at their centres; what is beyond the outer centres is
// moved onto them. Of an image the centres are in coordinates of its indices.
class Centres
{
public:
  explicit Centres(vtkDataSet* data)
    : Image(vtkImageData::SafeDownCast(data))
  {
    auto* grid = vtkRectilinearGrid::SafeDownCast(data);
    AxisCoordinates centres;
    for (int a = 0; a < 3; ++a)
    {
      const auto coordinate = [&](int i)
      {
        return this->Image ? this->Image->GetExtent()[2 * a] + i
                           : (a == 0    ? grid->GetXCoordinates()
                               : a == 1 ? grid->GetYCoordinates()
                                        : grid->GetZCoordinates())
                               ->GetComponent(i, 0);
      };
      const int points = (this->Image ? this->Image->GetDimensions() : grid->GetDimensions())[a];
      for (int i = 1; i < points; ++i)
      {
        centres.Axes[a].push_back(0.5 * (coordinate(i - 1) + coordinate(i)));
      }
    }
    this->Data = rectilinearOf(constantField(0.0), centres);
    this->Data->GetPointData()->SetScalars(data->GetCellData()->GetScalars());
  }

  double at(Vec3 point) const
  {
    if (this->Image)
    {
      const Vec3 physical = point;
      this->Image->TransformPhysicalPointToContinuousIndex(physical.data(), point.data());
    }
    const double* b = this->Data->GetBounds();
    for (int a = 0; a < 3; ++a)
    {
      // vtkRectilinearGrid finds no cell on its sides.
      const double margin = 1e-13 * (b[2 * a + 1] - b[2 * a]);
      point[a] = std::clamp(point[a], b[2 * a] + margin, b[2 * a + 1] - margin);
    }
    return interpolated(this->Data, point, LatticeValues::PointsLinear);
  }

private:
  vtkImageData* Image;
  vtkSmartPointer<vtkRectilinearGrid> Data;
};

struct Sampled
{
  std::array<double, 4> Rgba{};
  double Least = LatticeTruth::Infinity;
  double Greatest = -LatticeTruth::Infinity;
};

// By the midpoints of 4096 steps in each segment.
template <typename ScalarAt>
Sampled sampled(const std::vector<ScalarSegment>& segments, const Vec3& origin,
  const Vec3& direction, const OpticalModel& model, const ScalarAt& scalarAt)
{
  constexpr int Steps = 4096;
  Sampled all;
  for (const ScalarSegment& segment : segments)
  {
    const double step = (segment.T1 - segment.T0) / Steps;
    for (int k = 0; k < Steps; ++k)
    {
      const double t = segment.T0 + (k + 0.5) * step;
      const double f = scalarAt({ origin[0] + t * direction[0], origin[1] + t * direction[1],
        origin[2] + t * direction[2] });
      all.Least = std::min(all.Least, f);
      all.Greatest = std::max(all.Greatest, f);
      const double alpha = -std::expm1(-model.extinction(f) * step);
      const Vec3 colour = model.colour(f);
      for (int c = 0; c < 3; ++c)
      {
        all.Rgba[c] += (1.0 - all.Rgba[3]) * alpha * colour[c];
      }
      all.Rgba[3] += (1.0 - all.Rgba[3]) * alpha;
    }
  }
  return all;
}

void expectSampled(vtkDataSet* data, LatticeValues values)
{
  std::mt19937 generator(33);
  const OpticalModel model = spiky();
  const LatticeTruth truth(data, model, values);
  const Centres centres(data);
  const auto scalarAt = [&](const Vec3& p)
  { return values == LatticeValues::CellsLinear ? centres.at(p) : interpolated(data, p, values); };
  for (int i = 0; i < 4; ++i)
  {
    Vec3 d = randomDirection(generator);
    const double length = std::hypot(d[0], d[1], d[2]);
    Vec3 o = randomPoint(generator, 0.4, 0.6);
    for (int a = 0; a < 3; ++a)
    {
      const double* b = data->GetBounds();
      d[a] /= length;
      o[a] = b[2 * a] + o[a] * (b[2 * a + 1] - b[2 * a]) - 2.0 * data->GetLength() * d[a];
    }
    const Sampled expected = sampled(truth.segments(o, d), o, d, model, scalarAt);
    const auto seen = truth.integrate(o, d);
    EXPECT_GT(seen[3], 0.01);
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(seen[c], expected.Rgba[c], 1e-6) << c;
    }
    // The samples miss the extremes by little, and are not beyond them.
    const auto extremes = truth.extremes(o, d).value();
    EXPECT_NEAR(extremes[0], expected.Least, 1e-3);
    EXPECT_NEAR(extremes[1], expected.Greatest, 1e-3);
    EXPECT_LE(extremes[0], expected.Least + 1e-13);
    EXPECT_GE(extremes[1], expected.Greatest - 1e-13);
  }
}

class LatticeSampling : public testing::TestWithParam<LatticeValues>
{
};

TEST_P(LatticeSampling, OfAnImage)
{
  expectSampled(imageOf(noiseField(5, 16), imagePlaces().back()), this->GetParam());
}

TEST_P(LatticeSampling, OfARectilinearGrid)
{
  expectSampled(rectilinearOf(noiseField(5, 16), unevenCube(4)), this->GetParam());
}

INSTANTIATE_TEST_SUITE_P(AllValues, LatticeSampling,
  testing::Values(LatticeValues::PointsLinear, LatticeValues::PointsNearest,
    LatticeValues::CellsLinear, LatticeValues::CellsNearest));
} // namespace
