// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdint>

namespace tetmarch::testing
{
namespace
{
// The finaliser of MurmurHash3 (Appleby 2011), over a sum of coordinates times large odd numbers:
// every compiler gives the same noise.
double hashToUnit(std::int64_t i, std::int64_t j, std::int64_t k, unsigned seed)
{
  auto h = static_cast<std::uint32_t>(i) * 0x8da6b343u +
           static_cast<std::uint32_t>(j) * 0xd8163841u +
           static_cast<std::uint32_t>(k) * 0xcb1ab31fu + seed * 0x9e3779b9u;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return (h ^ (h >> 16)) / 4294967295.0;
}

double mix(double a, double b, double t) { return a + t * (b - a); }
} // namespace

Field constantField(double value)
{
  return [value](double, double, double) { return value; };
}

Field linearField()
{
  return [](double x, double y, double z) { return 0.2 * x + 0.3 * y + 0.5 * z; };
}

Field sineField(double waves)
{
  const double w = 2.0 * vtkMath::Pi() * waves;
  return [w](double x, double y, double z)
  { return 0.5 + 0.5 * std::sin(w * x) * std::sin(w * y + 1.0) * std::sin(w * z + 2.0); };
}

Field scatteredField(unsigned seed)
{
  return [seed](double x, double y, double z)
  {
    const double s = std::sin(12.9898 * x + 78.233 * y + 37.719 * z + seed) * 43758.5453;
    return s - std::floor(s);
  };
}

Field noiseField(unsigned seed, int frequency)
{
  return [seed, frequency](double x, double y, double z)
  {
    const double p[3] = { x * frequency, y * frequency, z * frequency };
    std::int64_t cell[3];
    double t[3];
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = static_cast<std::int64_t>(std::floor(p[a]));
      t[a] = p[a] - static_cast<double>(cell[a]);
    }
    double plane[2];
    for (int dz = 0; dz < 2; ++dz)
    {
      double line[2];
      for (int dy = 0; dy < 2; ++dy)
      {
        line[dy] = mix(hashToUnit(cell[0], cell[1] + dy, cell[2] + dz, seed),
          hashToUnit(cell[0] + 1, cell[1] + dy, cell[2] + dz, seed), t[0]);
      }
      plane[dz] = mix(line[0], line[1], t[1]);
    }
    return mix(plane[0], plane[1], t[2]);
  };
}

Field radialField()
{
  return [](double x, double y, double z)
  {
    const double p[3] = { x - 0.5, y - 0.5, z - 0.5 };
    return std::sqrt((p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 0.75);
  };
}

Field linearFieldAlong(double dx, double dy, double dz)
{
  const double width = std::abs(dx) + std::abs(dy) + std::abs(dz);
  return [=](double x, double y, double z)
  { return 0.5 + (dx * (x - 0.5) + dy * (y - 0.5) + dz * (z - 0.5)) / width; };
}

Field productField()
{
  return [](double x, double y, double z) { return x * y * z; };
}

Field marschnerLobbField()
{
  return [](double x, double y, double z)
  {
    const double pi = vtkMath::Pi();
    const double r = std::hypot(2.0 * x - 1.0, 2.0 * y - 1.0);
    const double ripples = std::cos(2.0 * pi * 6.0 * std::cos(0.5 * pi * r));
    return (1.0 - std::sin(0.5 * pi * (2.0 * z - 1.0)) + 0.25 * (1.0 + ripples)) / 2.5;
  };
}

Field stepField()
{
  return [](double x, double, double) { return x < 0.5 ? 0.0 : 1.0; };
}

Field checkerboardField(int n)
{
  return [n](double x, double y, double z)
  { return (std::lround(x * n) + std::lround(y * n) + std::lround(z * n)) % 2 == 0 ? 0.0 : 1.0; };
}

void attachFields(vtkUnstructuredGrid* grid, const Field& field)
{
  vtkNew<vtkDoubleArray> atPoints;
  atPoints->SetName("f");
  atPoints->SetNumberOfValues(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    atPoints->SetValue(i, field(p[0], p[1], p[2]));
  }
  grid->GetPointData()->SetScalars(atPoints);

  vtkNew<vtkDoubleArray> atCells;
  atCells->SetName("c");
  atCells->SetNumberOfValues(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCells()->GetCellAtId(i, ids);
    double mean[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      double p[3];
      grid->GetPoint(ids->GetId(k), p);
      for (int a = 0; a < 3; ++a)
      {
        mean[a] += p[a] / static_cast<double>(ids->GetNumberOfIds());
      }
    }
    atCells->SetValue(i, field(mean[0], mean[1], mean[2]));
  }
  grid->GetCellData()->SetScalars(atCells);
}
} // namespace tetmarch::testing
