// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches the rays of all pixels through the piece of a mesh that this process has, one visit after
// the other.
#ifndef TetMarchGLVisitPass_h
#define TetMarchGLVisitPass_h

#include "GL/MarchPass.h"
#include "Processes/Visits.h"

#include <array>
#include <utility>

namespace tetmarch
{

/** Rows of pixels, from the first to before the end. */
struct Band
{
  int FirstRow;
  int EndRow;
};

class VisitPass
{
public:
  /**
   * Collect the visits of a band of the inputs' area, whose pixels are counted from its first row.
   * `atOnce` is the share of a pixel's tolerance that this process may use up from the begin.
   * Returns an empty string, or what is wrong: also if a ray comes back more often than can be
   * counted. `stopped` becomes true if progress asked to stop, `tooMuch` if the lists would take
   * more than so many bytes: then they are not whole.
   */
  std::string collect(vtkOpenGLRenderWindow* window, MarchPass& march, const MarchInputs& inputs,
    const Band& band, float atOnce, std::uint64_t mostBytes, const Progress& progress,
    bool& stopped, bool& tooMuch, VisitLists& lists);
  /** Drawings since the last call. */
  int takeDraws() { return std::exchange(this->Draws, 0); }
  std::size_t bytes() const { return this->Targets[0].bytes() + this->Targets[1].bytes(); }
  void expectChange() { this->Tiles.expectChange(); }
  void release(vtkWindow* window);

private:
  Viewport take(vtkOpenGLRenderWindow* window, const FloatTarget& target, const MarchInputs& inputs,
    const Viewport& part, const Band& band, VisitLists& lists) const;

  std::array<FloatTarget, 2> Targets; // by turns: each visit goes on from the one before
  TileSchedule Tiles;
  int Draws = 0;
};

} // namespace tetmarch

#endif
