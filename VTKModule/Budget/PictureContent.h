// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The properties that determine the time of a picture.
#ifndef TetMarchBudgetPictureContent_h
#define TetMarchBudgetPictureContent_h

#include "Caching/Fingerprint.h"

#include <array>

namespace tetmarch
{

/** The part of a picture whose cost may differ from the last one. */
enum class PictureChange
{
  None,
  Part,   // the newly visible part, after a small move of the camera
  Whole,  // everything: the camera has moved far, or opaque geometry has changed
  Another // everything, maybe with another shader: data, functions, cuts or light have changed
};

/** A rectangle of the screen; x and y are in -1..1 within the whole picture. */
struct ScreenBox
{
  std::array<double, 2> Low;
  std::array<double, 2> High;
  bool operator!=(const ScreenBox& other) const
  {
    return this->Low != other.Low || this->High != other.High;
  }
};

struct PictureContent
{
  static constexpr ScreenBox All{ { { -1, -1 } }, { { 1, 1 } } };

  /** The version of everything that determines the cost of a ray except the camera and opaque
   * geometry: data, functions, cuts, accuracy, shader. */
  Fingerprint Version;
  /** The version of opaque geometry, at which rays end. */
  Fingerprint Surroundings;
  /** The corners of the volume's bounding box on the screen; infinite behind the eye. */
  std::array<std::array<double, 2>, 8> Corners{ { All.Low, All.High, All.High, All.High, All.High,
    All.High, All.High, All.High } };
  /** The drawn part of the picture. */
  ScreenBox Drawn = All;
  /** Parts of rays are drawn, which may differ each time. */
  bool IsLayer = false;
  /** Number of rays per pixel. */
  double RaysPerPixel = 1;

  /** The bounding box of the corners; infinite if one of them is. */
  ScreenBox box() const;
  /** Whether the drawn part contains the whole volume, and the rays are whole. */
  bool showsWhole() const;
  PictureChange changeFrom(const PictureContent& last) const;
  /** The share of pixels, 0..1, that may show parts that the last picture did not. */
  double exposedSince(const PictureContent& last) const;
};

} // namespace tetmarch

#endif
