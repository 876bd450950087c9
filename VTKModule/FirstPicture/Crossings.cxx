// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/Crossings.h"

#include "FirstPicture/CellPieces.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace tetmarch
{

namespace
{

constexpr int LongerSide = 96;              // of the picture, in pixels
constexpr vtkIdType MostCells = 1 << 17;    // of a block
constexpr double PointsOfAPixel = 4;        // per cell in front of a pixel
constexpr double MostPointsOfAPiece = 4096; // for any number of covered pixels
constexpr double MostDepth = 1e290;         // of a crossing: sums of them are finite

struct PixelGrid
{
  PicturePlane Plane;
  double Left = 0;
  double Bottom = 0;
  double Size = 1; // of a pixel in the world
  int Width = 1;
  int Height = 1;

  int pixelOf(const Vector3& point) const
  {
    const double x = (dot(point, this->Plane.Right) - this->Left) / this->Size;
    const double y = (dot(point, this->Plane.Up) - this->Bottom) / this->Size;
    return pixelAt(y, this->Height) * this->Width + pixelAt(x, this->Width);
  }

private:
  // 0 for NaN.
  static int pixelAt(double place, int count)
  {
    return place > 0 ? static_cast<int>(std::min(place, count - 1.0)) : 0;
  }
};

PixelGrid gridOver(const std::vector<Vector3>& points, const PicturePlane& plane)
{
  using Limits = std::numeric_limits<double>;
  double least[2] = { Limits::max(), Limits::max() };
  double most[2] = { Limits::lowest(), Limits::lowest() };
  for (const Vector3& point : points)
  {
    const double place[2] = { dot(point, plane.Right), dot(point, plane.Up) };
    for (int k = 0; k < 2; ++k)
    {
      least[k] = std::min(least[k], place[k]);
      most[k] = std::max(most[k], place[k]);
    }
  }
  PixelGrid grid;
  grid.Plane = plane;
  const double longer = points.empty() ? 0 : std::max(most[0] - least[0], most[1] - least[1]);
  if (longer > 0 && std::isfinite(longer))
  {
    grid.Left = least[0];
    grid.Bottom = least[1];
    grid.Size = longer / LongerSide;
    grid.Width = std::max(1, static_cast<int>(std::ceil((most[0] - least[0]) / grid.Size)));
    grid.Height = std::max(1, static_cast<int>(std::ceil((most[1] - least[1]) / grid.Size)));
  }
  return grid;
}

// Portable, unlike std::uniform_real_distribution.
double fraction(std::mt19937& random) { return random() / 4294967296.0; }

// Uniform in a tetrahedron: the gaps between three sorted uniform numbers (L. Devroye, Non-Uniform
// Random Variate Generation, 1986).
std::array<double, 4> barycentric(std::mt19937& random)
{
  std::array<double, 3> u{ { fraction(random), fraction(random), fraction(random) } };
  std::sort(u.begin(), u.end());
  return { { u[0], u[1] - u[0], u[2] - u[1], 1 - u[2] } };
}

class Spreading
{
public:
  Spreading(const PixelGrid& grid, std::vector<Crossing>& list)
    : Grid(grid)
    , List(list)
  {
  }

  // share: the number of cells that this one represents. A cell smaller than a pixel becomes one
  // point of one of its pieces.
  void spreadCell(const std::vector<ValuedPiece>& pieces, double share)
  {
    double volume = 0;
    for (const ValuedPiece& piece : pieces)
    {
      volume += piece.Volume;
    }
    if (this->pointsFor(volume) <= 1)
    {
      double left = fraction(this->Random) * volume;
      for (const ValuedPiece& piece : pieces)
      {
        left -= piece.Volume;
        if (left < 0)
        {
          this->spreadPiece(piece, 1, share * volume);
          return;
        }
      }
    }
    for (const ValuedPiece& piece : pieces)
    {
      this->spreadPiece(piece, this->pointsFor(piece.Volume), share * piece.Volume);
    }
  }

  void spreadAll(vtkDataSet* block, const DrawnValues& values)
  {
    CellCutting cutting(block, values);
    const vtkIdType count = block->GetNumberOfCells();
    const vtkIdType step = (count + MostCells - 1) / MostCells;
    for (vtkIdType first = 0; first < count; first += step)
    {
      const vtkIdType group = std::min(step, count - first);
      const vtkIdType cell = first + static_cast<vtkIdType>(fraction(this->Random) * group);
      this->spreadCell(cutting.cut(cell), static_cast<double>(group));
    }
  }

private:
  int pointsFor(double volume) const
  {
    const double side = std::cbrt(volume) / this->Grid.Size;
    const double points = PointsOfAPixel * side * side;
    return points > 0 ? static_cast<int>(std::ceil(std::min(points, MostPointsOfAPiece))) : 0;
  }

  // volume: the volume represented by the points.
  void spreadPiece(const ValuedPiece& piece, int points, double volume)
  {
    const double length = volume / (this->Grid.Size * this->Grid.Size) / points;
    for (int i = 0; i < points; ++i)
    {
      const std::array<double, 4> weights = barycentric(this->Random);
      Vector3 point{};
      double value = 0;
      for (int k = 0; k < 4; ++k)
      {
        add(weights[k], piece.Corners[k].Point, point);
        value += weights[k] * piece.Corners[k].Value;
      }
      if (std::isfinite(value))
      {
        this->List.push_back({ this->Grid.pixelOf(point), length, value });
      }
    }
  }

  const PixelGrid& Grid;
  std::vector<Crossing>& List;
  std::mt19937 Random{ 1 };
};

} // namespace

std::vector<double> Crossings::opticalDepths(const std::function<double(double)>& extinction) const
{
  std::vector<double> depths(static_cast<std::size_t>(this->Width) * this->Height, 0.0);
  for (const Crossing& crossing : this->List)
  {
    const double depth = crossing.Length * extinction(crossing.Value);
    depths[crossing.Pixel] += depth > 0 ? std::min(depth, MostDepth) : 0;
  }
  return depths;
}

std::vector<double> Crossings::lengths() const
{
  return this->opticalDepths([](double) { return 1.0; });
}

std::vector<Sample> Crossings::samples() const
{
  std::vector<Sample> samples;
  samples.reserve(this->List.size());
  for (const Crossing& crossing : this->List)
  {
    samples.push_back({ crossing.Value, crossing.Length * std::sqrt(crossing.Length) });
  }
  return samples;
}

Crossings findCrossings(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn,
  const std::vector<Vector3>& points, const PicturePlane& plane)
{
  const PixelGrid grid = gridOver(points, plane);
  Crossings crossings;
  crossings.Width = grid.Width;
  crossings.Height = grid.Height;
  Spreading spreading(grid, crossings.List);
  for (vtkDataSet* block : blocks)
  {
    if (const DrawnValues values(block, drawn); values)
    {
      spreading.spreadAll(block, values);
    }
  }
  return crossings;
}

} // namespace tetmarch
