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

class PiecesPicture
{
public:
  /**
   * Collective. March the area of the inputs and blend the picture of all processes over that of
   * the window; interpolated if the viewport, `area`, is larger. `before` is what has gone wrong in
   * this process so far: then nothing is marched. Returns an empty string, or what is wrong with
   * any process; `stopped` becomes true if progress asked one of them to stop. In both cases no
   * process draws anything.
   */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& area, MarchPass& march,
    const MarchInputs& inputs, const PartStatus& before, SharedPicture& shared,
    PictureApart& picture, const Progress& progress, bool& stopped);
  int numberOfDraws() const { return this->Draws; }
  std::size_t bytes() const { return this->Visits.bytes(); }
  void forgetTimes() { this->Visits.forgetTimes(); }
  void release(vtkWindow* window) { this->Visits.release(window); }

private:
  PartStatus march(vtkOpenGLRenderWindow* window, MarchPass& march, const MarchInputs& inputs,
    const VisitTurn& turn, const PartStatus& before, SharedPicture& shared,
    const Progress& progress, VisitLists& lists);
  PartStatus drawBand(vtkOpenGLRenderWindow* window, MarchPass& march, const MarchInputs& inputs,
    const Band& band, const PartStatus& before, SharedPicture& shared, const Progress& progress,
    MergedPicture& merged);
  VisitTurn firstTurn(const Band& band, bool canHide) const;
  PartStatus drawInBands(vtkOpenGLRenderWindow* window, MarchPass& march, const MarchInputs& inputs,
    const PartStatus& before, SharedPicture& shared, const Progress& progress,
    MergedPicture& merged);

  VisitPass Visits;
  ExpectedDepths Expected;
  int Bands = 1; // of the last picture; what is drawn next may need as many
  int Draws = 0;
};

} // namespace tetmarch

#endif
