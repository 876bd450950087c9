// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HalfFloats.h"

#include "Parallel/ParallelFor.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tetmarch
{
namespace
{

constexpr double LargestStored = 60000;

constexpr std::uint16_t LargestHalf = 0x7bff;
constexpr std::uint16_t NoNumber = 0x7e00;

// Shift right by `shift` bits and round to nearest, ties to even.
std::uint32_t shiftedAndRounded(std::uint32_t bits, std::uint32_t shift)
{
  const std::uint32_t half = 1u << (shift - 1);
  const std::uint32_t odd = bits >> shift & 1;
  return (bits + (half - 1) + odd) >> shift;
}

double largestComponent(const std::vector<Gradient>& gradients)
{
  vtkSMPThreadLocal<float> largest(0.0f);
  parallelFor(0, static_cast<vtkIdType>(gradients.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      float& mine = largest.Local();
      for (vtkIdType i = first; i < last; ++i)
      {
        for (const float component : gradients[i])
        {
          if (std::isfinite(component))
          {
            mine = std::max(mine, std::abs(component));
          }
        }
      }
    });
  float all = 0;
  for (const float mine : largest)
  {
    all = std::max(all, mine);
  }
  return static_cast<double>(all);
}

} // namespace

std::uint16_t toHalf(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000);
  const std::uint32_t size = bits & 0x7fffffff;
  if (size > 0x7f800000)
  {
    return sign | NoNumber;
  }
  const std::uint32_t exponent = size >> 23;
  if (exponent > 112)
  {
    // Rounding up may carry into the exponent, which makes the next power of 2.
    const std::uint32_t half = shiftedAndRounded(size - (112u << 23), 13);
    return static_cast<std::uint16_t>(sign | std::min<std::uint32_t>(half, LargestHalf));
  }
  if (exponent < 102)
  {
    return sign; // less than half of the smallest one
  }
  const std::uint32_t mantissa = (size & 0x7fffff) | 0x800000;
  return static_cast<std::uint16_t>(sign | shiftedAndRounded(mantissa, 126 - exponent));
}

PackedGradients packGradients(const std::vector<Gradient>& gradients)
{
  PackedGradients packed;
  const double largest = largestComponent(gradients);
  packed.Unit = largest > 0 ? largest / LargestStored : 1;
  packed.Texels.resize(gradients.size());
  parallelFor(0, static_cast<vtkIdType>(gradients.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          packed.Texels[i][k] =
            toHalf(static_cast<float>(static_cast<double>(gradients[i][k]) / packed.Unit));
        }
        packed.Texels[i][3] = 0;
      }
    });
  return packed;
}

} // namespace tetmarch
