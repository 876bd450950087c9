// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches the rays of all pixels through the piece of a mesh that this process has, one visit after
// the other.
#ifndef TetMarchGLVisitPass_h
#define TetMarchGLVisitPass_h

#include "GL/MarchPass.h"
#include "GL/UploadedImage.h"
#include "Processes/NextEntries.h"
#include "Processes/SharedPicture.h"

#include <utility>

namespace tetmarch
{

/** Rows of pixels, from the first to before the end. */
struct Band
{
  int FirstRow;
  int EndRow;
};

/** How far rays go before the processes tell each other what they hide. */
struct VisitTurn
{
  int MostVisits;            // of a ray; more if only few rays are left
  HiddenDepths Hidden;       // of the band: rays don't enter there,
  bool HiddenIsSure = false; // and end; else they wait
  float AtOnce = 0;          // share of a pixel's tolerance that may be used up here from the begin
  std::uint64_t MostBytes = 0; // of all lists of the band
};

class VisitPass
{
public:
  /** Begin with a band of an area: all rays, or none if this process has no piece. */
  void begin(const Viewport& area, const Band& band, bool hasPiece);
  /**
   * Collect further visits of the band, whose pixels are counted from its first row. It fails also
   * if a ray comes back more often than can be counted. The lists are not whole if they would take
   * too much memory, or if it is stopped.
   */
  PartStatus collect(const DrawContext& context, MarchPass& march, const MarchInputs& inputs,
    const VisitTurn& turn, VisitLists& lists);
  /** Rays that enter where that is hidden end. */
  void endHidden(const HiddenDepths& hidden) { this->Ended += this->Next.endHidden(hidden); }
  /** Whether some rays have not ended. */
  bool waits() const { return this->Next.any(); }
  /** Rays of the band that have ended so. */
  std::size_t numberOfEnded() const { return this->Ended; }
  /** Drawings since the last call. */
  int takeDraws() { return std::exchange(this->Draws, 0); }
  std::size_t bytes() const
  {
    return this->Target.bytes() + this->Rays.bytes() + this->Hidden.bytes();
  }
  void forgetTimes() { this->Tiles.forget(); }
  void release(vtkWindow* window);

private:
  std::string bind(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const VisitTurn& turn);
  void take(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part,
    VisitLists& lists);
  void takeRows(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part,
    VisitLists& lists);

  FloatTarget Target;                // of a drawing
  FloatTarget Rays;                  // where each ray is after its last visit
  std::vector<float> Depths, Colors; // of some rows of the target
  UploadedImage Hidden;
  TileSchedule Tiles;
  Band Rows{ 0, 0 };
  NextEntries Next;
  int Visits = 0; // of a ray so far
  std::size_t Bytes = 0;
  std::size_t Ended = 0;
  int Draws = 0;
};

} // namespace tetmarch

#endif
