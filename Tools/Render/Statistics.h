// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What --stats writes.
 */
#ifndef tetmarch_Statistics_h
#define tetmarch_Statistics_h

#include "CommandLine.h"
#include "VolumeData.h"

#include <string>
#include <vector>

class vtkRenderWindow;
class vtkTetMarchFirstPicture;
class vtkTetMarchFrameStatistics;

namespace tetmarch
{

struct Timing
{
  double Read = 0.0;
  double FirstFrame = 0.0; // includes the stages of the mapper
  std::vector<double> Frames;
};

/// 0 of no values; the mean of the middle two of an even number.
double GetMedian(std::vector<double> values);

/**
 * The JSON text.
 */
std::string FormatStatistics(const CommandLine& commandLine, const VolumeData& data,
  vtkTetMarchFirstPicture* choice, vtkTetMarchFrameStatistics* statistics, vtkRenderWindow* window,
  const Timing& timing);

} // namespace tetmarch

#endif
