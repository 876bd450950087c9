// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Compare two RGBA images in numbers, and write one to look at
 */
#ifndef tetmarch_testing_Images_h
#define tetmarch_testing_Images_h

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tetmarch::testing
{
/// RGBA in 0..1, rows from the bottom up as OpenGL reads them.
struct Image
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Rgba;

  Image() = default;
  /// All zero.
  Image(int width, int height);

  static Image fromBytes(int width, int height, const unsigned char* rgba);
  static Image fromFloats(int width, int height, const float* rgba);

  float* pixel(int x, int y);
  const float* pixel(int x, int y) const;
};

/// One flag a pixel: which of them count.
using Mask = std::vector<bool>;
/// Pixels with alpha above a threshold in either image: the silhouette.
Mask silhouette(const Image& a, const Image& b, float alpha = 0.0f);
/// Pixels whose colours (not alpha) differ by more than the threshold from a background.
Mask differsFrom(const Image& image, const float background[3], float threshold = 0.0f);

/// Differences over the pixels of a mask. The difference of a pixel is that of its worst channel;
/// RMS is over all channels. A value that isn't finite in either image counts as a difference of
/// infinity.
struct Difference
{
  std::size_t Pixels = 0;
  double Max = 0.0;
  double Rms = 0.0;
  double Percentile999 = 0.0; ///< at most 1 pixel in 1000 differs by more
  std::size_t Over = 0;       ///< pixels that differ by more than the threshold
  int WorstX = -1;
  int WorstY = -1;

  /// One line, differences in units of 1/255.
  std::string text() const;
};

enum class Channels
{
  Rgb = 3,
  Rgba = 4
};

/// Throws std::invalid_argument if the sizes differ. Empty mask: all pixels.
Difference compare(const Image& a, const Image& b, const Mask& mask = {},
  double threshold = 2.0 / 255.0, Channels channels = Channels::Rgba);

/// |a - b| times a gain, clamped to 1, alpha 1: to see where two images differ.
Image differenceImage(const Image& a, const Image& b, float gain = 64.0f);

/// As an 8-bit PNG of all four channels, or of RGB as it would stand on a black ground. False if it
/// can't be written.
bool writePng(const Image& image, const std::string& fileName, Channels channels = Channels::Rgb);
} // namespace tetmarch::testing

#endif
