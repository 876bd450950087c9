// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How often the values of an array occur.
 */
#ifndef tetmarch_Histogram_h
#define tetmarch_Histogram_h

#include <vector>

class vtkTetMarchFirstPicture;

namespace tetmarch
{
struct VolumeData;

struct Histogram
{
  std::vector<double> Counts; // of bins of equal width
  double Low = 0.0;
  double High = 1.0;
};

/// Of the chosen array of all blocks, over its whole range.
Histogram CountValues(const VolumeData& data, vtkTetMarchFirstPicture* choice);

} // namespace tetmarch

#endif
