// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The unit ball in triangles
 */
#ifndef tetmarch_testing_Ball_h
#define tetmarch_testing_Ball_h

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tetmarch::testing
{
/// Closed, of rings between two poles; nowhere further in than cos(pi / rings) cos(pi / sectors).
struct Ball
{
  Ball(int rings, int sectors)
  {
    constexpr double pi = 3.14159265358979323846;
    this->Points.push_back({ { 0.0, 0.0, 1.0 } });
    for (int r = 1; r < rings; ++r)
    {
      for (int s = 0; s < sectors; ++s)
      {
        const double theta = pi * r / rings;
        const double phi = 2.0 * pi * s / sectors;
        this->Points.push_back({ { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
          std::cos(theta) } });
      }
    }
    this->Points.push_back({ { 0.0, 0.0, -1.0 } });
    const auto at = [&](int r, int s)
    {
      const int last = static_cast<int>(this->Points.size()) - 1;
      const int point = r == 0 ? 0 : (r == rings ? last : 1 + (r - 1) * sectors + s % sectors);
      return static_cast<std::uint32_t>(point);
    };
    for (int r = 0; r < rings; ++r)
    {
      for (int s = 0; s < sectors; ++s)
      {
        this->add(at(r, s), at(r + 1, s), at(r + 1, s + 1));
        this->add(at(r, s), at(r + 1, s + 1), at(r, s + 1));
      }
    }
  }

  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<std::uint32_t, 3>> Triangles;

private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    if (a != b && b != c && c != a)
    {
      this->Triangles.push_back({ { a, b, c } });
    }
  }
};
} // namespace tetmarch::testing

#endif
