// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture of a volume of which several processes have pieces: each marches its own, and gets
// the picture of all.
#ifndef TetMarchGLPiecesPicture_h
#define TetMarchGLPiecesPicture_h

#include "GL/PictureApart.h"
#include "GL/VisitPass.h"
#include "Processes/ExpectedDepths.h"
#include "Processes/SharedPicture.h"

namespace tetmarch
{

/** A picture of pieces as this process draws it. */
struct PiecesDraw
{
  const DrawContext& Context;
  MarchPass& March;
  const MarchInputs& Inputs;
  const StageResult& Before; // how this process has got on so far
  SharedPicture& Shared;
};

class PiecesPicture
{
public:
  /**
   * Collective. March the area of the inputs and blend the picture of all processes over that of
   * the window; interpolated if the viewport, `area`, is larger. If something has gone wrong in
   * this process before, nothing is marched. The result is that of all processes; unless it is
   * done, no process draws anything.
   */
  StageResult draw(const PiecesDraw& pieces, const Viewport& area, PictureApart& picture);
  int numberOfDraws() const { return this->Draws; }
  std::size_t bytes() const { return this->Visits.bytes(); }
  void forgetTimes() { this->Visits.forgetTimes(); }
  void release(vtkWindow* window) { this->Visits.release(window); }

private:
  PartStatus march(const PiecesDraw& pieces, const VisitTurn& turn, VisitLists& lists);
  PartStatus drawBand(const PiecesDraw& pieces, const Band& band, MergedPicture& merged);
  VisitTurn firstTurn(const PiecesDraw& pieces, const Band& band, bool canHide) const;
  PartStatus drawInBands(const PiecesDraw& pieces, MergedPicture& merged);

  VisitPass Visits;
  ExpectedDepths Expected;
  int Bands = 1; // of the last picture; what is drawn next may need as many
  int Draws = 0;
};

} // namespace tetmarch

#endif
