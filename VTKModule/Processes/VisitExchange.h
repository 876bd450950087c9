// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The visits of all processes become one picture (direct send; Hsu, "Segmented ray casting for data
// parallel volume rendering", 1993; of lists of fragments as in Ma and Crockett, "A scalable
// parallel cell-projection volume rendering algorithm for three-dimensional unstructured data",
// 1997).
#ifndef TetMarchProcessesVisitExchange_h
#define TetMarchProcessesVisitExchange_h

#include "Processes/Group.h"
#include "Processes/Visits.h"

namespace tetmarch
{

/** Row y of the picture is merged by process y modulo their number: what is hard to merge lies side
 * by side, and so is shared out. */
inline int mergerOf(int row, int processes) { return row % processes; }

/** The visits of the rows that a process merges: of each row from the first to the last pixel with
 * visits a number of visits, then the visits. */
Bytes packVisits(const VisitLists& lists, int merger, int processes);

/** A picture of merged pixels, rows from the bottom. */
struct MergedPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Gathered; // four a pixel
  float WorstError = 0;        // of all pixels
};

/** What the merging of a picture took. */
struct ExchangeFigures
{
  double ExchangeSeconds = 0;
  double MergeSeconds = 0;
  double SpreadSeconds = 0; // to tell all processes the merged rows
};

/**
 * Collective. Each process gives the visits of its piece, all of a picture of one size, and gets
 * the whole picture. `opaque` as in mergeVisits().
 */
MergedPicture mergeTogether(
  Group& group, const VisitLists& own, MergeRule rule, float opaque, ExchangeFigures& figures);

} // namespace tetmarch

#endif
