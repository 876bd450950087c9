// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Merges the visits of all processes into one picture (direct send; Hsu, "Segmented ray casting for
// data parallel volume rendering", 1993; of lists of fragments as in Ma and Crockett, "A scalable
// parallel cell-projection volume rendering algorithm for three-dimensional unstructured data",
// 1997).
#ifndef TetMarchProcessesVisitExchange_h
#define TetMarchProcessesVisitExchange_h

#include "Processes/Group.h"
#include "Processes/HiddenDepths.h"
#include "Processes/Visits.h"

namespace tetmarch
{

/** Row y of the picture is merged by process y modulo their number, so that expensive adjacent rows
 * are distributed. */
inline int mergerOf(int row, int processes) { return row % processes; }

/** A picture of merged pixels, rows from the bottom. */
struct MergedPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Gathered; // four per pixel
  float WorstError = 0;        // of all pixels
  HiddenDepths Hidden;         // of rows that have hidden visits; empty if none has
};

/** The cost of the merge of a picture. */
struct ExchangeFigures
{
  double ExchangeSeconds = 0;
  double MergeSeconds = 0;
  double SpreadSeconds = 0; // of sending the merged rows to all processes
};

/** All methods are collective. The picture does not depend on the number of turns in which visits
 * are added. */
class VisitExchange
{
public:
  /** `opaque` as in mergeVisits(). */
  VisitExchange(
    Group& group, int width, int height, MergeRule rule, float opaque, ExchangeFigures& figures);

  /** Each process adds visits of its piece, in a picture of that size. */
  void add(const VisitLists& own);
  /** The depths hidden by all added visits. */
  HiddenDepths tellHidden();
  /** The whole picture. */
  MergedPicture spread();

private:
  void mergeOwnRows();
  MergedPicture unpack(const std::vector<Bytes>& all) const;
  MergedPixel* ownRow(int y)
  {
    return &this->Rows[std::size_t(y / this->Processes.size()) * this->Width];
  }

  Group& Processes;
  int Width, Height;
  MergeRule Rule;
  float Opaque;
  ExchangeFigures& Figures;
  std::vector<Bytes> Received;   // visits of the rows that this process merges, turn by turn
  std::vector<MergedPixel> Rows; // that this process merges
};

} // namespace tetmarch

#endif
