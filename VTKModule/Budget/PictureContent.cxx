// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/PictureContent.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// Maximum motion of a corner for a small move, as a share of the picture's side.
constexpr double LittleMotion = 0.05;

// The maximum motion of a corner, as a share of the picture's side; infinite if unknown.
double motion(const PictureContent& a, const PictureContent& b)
{
  double longest = 0;
  for (std::size_t i = 0; i < a.Corners.size(); ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      const double way = std::abs(a.Corners[i][k] - b.Corners[i][k]) / 2;
      longest = way >= 0 ? std::max(longest, way) : HUGE_VAL; // infinite ones have no difference
    }
  }
  return longest;
}

bool showsOtherRays(const PictureContent& content, const PictureContent& last)
{
  return content.IsLayer || last.IsLayer || content.Drawn != last.Drawn;
}

} // namespace

ScreenBox PictureContent::box() const
{
  ScreenBox box{ this->Corners[0], this->Corners[0] };
  for (const std::array<double, 2>& corner : this->Corners)
  {
    for (int k = 0; k < 2; ++k)
    {
      const bool finite = std::isfinite(corner[k]);
      box.Low[k] = finite ? std::min(box.Low[k], corner[k]) : -HUGE_VAL;
      box.High[k] = finite ? std::max(box.High[k], corner[k]) : HUGE_VAL;
    }
  }
  return box;
}

bool PictureContent::showsWhole() const
{
  const ScreenBox box = this->box();
  return !this->IsLayer && box.Low[0] >= this->Drawn.Low[0] && box.Low[1] >= this->Drawn.Low[1] &&
         box.High[0] <= this->Drawn.High[0] && box.High[1] <= this->Drawn.High[1];
}

PictureChange PictureContent::changeFrom(const PictureContent& last) const
{
  if (this->Version != last.Version || this->RaysPerPixel != last.RaysPerPixel)
  {
    return PictureChange::Another;
  }
  const bool moved = this->Corners != last.Corners;
  if (this->Surroundings != last.Surroundings || (moved && !(motion(*this, last) <= LittleMotion)))
  {
    return PictureChange::Whole;
  }
  return moved || showsOtherRays(*this, last) ? PictureChange::Part : PictureChange::None;
}

double PictureContent::exposedSince(const PictureContent& last) const
{
  switch (this->changeFrom(last))
  {
    case PictureChange::None:
      return 0;
    case PictureChange::Part: // it comes in along both sides
      return showsOtherRays(*this, last) ? 1 : 2 * motion(*this, last);
    default:
      return 1;
  }
}

} // namespace tetmarch
