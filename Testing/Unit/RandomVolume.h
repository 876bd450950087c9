// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A volume of random scalars and gradients for kernels of extinction.
#ifndef tetmarch_testing_RandomVolume_h
#define tetmarch_testing_RandomVolume_h

#include "Mesh/HiddenCells.h"
#include "Mesh/VertexStarts.h"

#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace tetmarch::testing
{
/// Ramps, steps and spikes of a bin.
inline IntegralTable bumpyTable()
{
  return tableOf(
    [](double f)
    {
      const int sample = static_cast<int>(std::lround(1023.0 * f));
      const double extinction = sample % 37 == 0 ? 1.0 : sample % 256 < 128 ? 0.3 * f : 0.05;
      return std::array<double, 4>{ { 1.0, 1.0, 1.0, extinction } };
    });
}

/// A mesh of random scalars and gradients, and how thick it is.
template <typename Kernel>
struct RandomVolume
{
  RandomVolume(vtkUnstructuredGrid* grid, bool cellGradients)
    : Mesh(builtWithHierarchy(grid))
    , Starts(vertexStarts(Mesh))
    , CellScalars(Mesh.numberOfTets())
  {
    // One in 64 isn't drawn, and at points many are alike.
    const auto scalar = [&]
    {
      const double x = uniform(this->Random);
      return this->Random() % 64 == 0 ? UndrawnScalar
                                      : static_cast<float>(x < 0.3 ? 0.25 + 1e-6 * x : x);
    };
    std::generate(this->CellScalars.begin(), this->CellScalars.end(), scalar);
    for (Vertex& v : this->Mesh.Vertices)
    {
      v.Scalar = scalar();
    }
    this->Effects.CellGradients = cellGradients;
    this->Effects.Gradients.resize(
      cellGradients ? this->Mesh.Tets.size() : this->Mesh.Vertices.size());
    for (auto& gradient : this->Effects.Gradients)
    {
      for (float& x : gradient)
      {
        x = static_cast<float>(uniform(this->Random));
      }
    }
    this->Effects.GradientOpacity.Values = { 0.0f, 1.0f, 0.2f, 0.7f };
    this->Effects.GradientOpacityScale = 3.0;
    this->March = kernelOf<Kernel, double>(this->Mesh, this->Table, LightAccuracy);
    this->March.CellScalars = this->CellScalars.data();
    // Two in 32 tetrahedra are hidden, and what isn't finite has an extinction.
    this->Hidden.resize(this->CellScalars.size() / 32 + 1);
    std::generate(this->Hidden.begin(), this->Hidden.end(),
      [&] { return 1u << this->Random() % 32 | 1u << this->Random() % 32; });
    this->March.HiddenCells = this->Hidden.data();
    this->March.nanColor = { 0.1, 0.2, 0.3, 0.4 };
    this->March.useEffects(this->Effects);
  }

  /// Scalar opacity unit distances in a unit of depth, at random.
  double nextLength()
  {
    const double length = std::pow(10.0, 3.0 * uniform(this->Random) - 1.0);
    this->Camera.ThicknessMatrix = { { length, 0, 0, 0, length, 0, 0, 0, length } };
    return length;
  }

  glsl::Vec3<double> nextDirection()
  {
    std::normal_distribution<double> normal;
    return glsl::normalize(
      glsl::Vec3<double>(normal(this->Random), normal(this->Random), normal(this->Random)));
  }

  /// A random point in the tetrahedron.
  glsl::Vec3<double> nextPoint(const std::array<Id, 4>& corners)
  {
    glsl::Vec3<double> point(0, 0, 0);
    double sum = 0.0;
    for (const Id corner : corners)
    {
      const double share = 0.05 + uniform(this->Random);
      const Vertex& v = this->Mesh.Vertices[corner];
      point = point + glsl::Vec3<double>(v.X, v.Y, v.Z) * share;
      sum += share;
    }
    return point * (1.0 / sum);
  }

  std::mt19937 Random{ 17 };
  TetMesh Mesh;
  std::vector<std::array<Id, 4>> Starts;
  std::vector<float> CellScalars;
  HiddenCells Hidden;
  const IntegralTable Table = bumpyTable();
  EffectData Effects;
  View Camera;
  Kernel March;
};
} // namespace tetmarch::testing

#endif
