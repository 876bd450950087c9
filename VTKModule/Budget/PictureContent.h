// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What decides how long a picture takes to draw.
#ifndef TetMarchBudgetPictureContent_h
#define TetMarchBudgetPictureContent_h

#include "Caching/Fingerprint.h"

#include <array>

namespace tetmarch
{

/** What of a picture may cost something else than in the last one. */
enum class PictureChange
{
  None,
  Part,   // what comes into the picture, where the camera has moved a little
  Whole,  // everything: the camera has moved far, or opaque geometry has changed
  Another // the same, and another shader may draw it: data, functions, cuts or light have changed
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

  /** Changes with anything that decides what a ray costs, but for the camera and opaque geometry:
   * data, functions, cuts, accuracy, shader. */
  Fingerprint Version;
  /** Changes with opaque geometry, at which rays end. */
  Fingerprint Surroundings;
  /** Where the corners of the volume's bounding box are on the screen; infinite behind the eye. */
  std::array<std::array<double, 2>, 8> Corners{ { All.Low, All.High, All.High, All.High, All.High,
    All.High, All.High, All.High } };
  /** The part of the picture that is drawn. */
  ScreenBox Drawn = All;
  /** Parts of rays are drawn, which may be other ones each time. */
  bool IsLayer = false;
  /** Each pixel marches this number of rays. */
  double RaysPerPixel = 1;

  /** The bounding box of the corners; infinite if one of them is. */
  ScreenBox box() const;
  /** Whether the whole volume is within what is drawn, and the rays are whole. */
  bool showsWhole() const;
  PictureChange changeFrom(const PictureContent& last) const;
  /** The share of the pixels, 0..1, that may show something that the last picture did not. */
  double exposedSince(const PictureContent& last) const;
};

} // namespace tetmarch

#endif
