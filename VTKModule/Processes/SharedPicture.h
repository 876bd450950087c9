// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture drawn by several processes.
#ifndef TetMarchProcessesSharedPicture_h
#define TetMarchProcessesSharedPicture_h

#include "Processes/VisitExchange.h"

namespace tetmarch
{

/** The processes of the picture, and the cost for this process. */
struct SharedPicture
{
  Group* Processes = nullptr;
  bool HasPiece = true;        // this process has cells of the volume
  std::uint64_t MostBytes = 0; // for the lists of visits
  double MarchSeconds = 0;
  ExchangeFigures Exchange;
  std::uint64_t Visits = 0;
  int Bands = 1;                     // of rows, drawn one after the other
  std::uint64_t SentBytesBefore = 0; // by this process, before this frame
  std::uint64_t SentBytes = 0;       // by this process, in this frame
  double WorstError = 0;             // error bound of a channel, maximum over the pixels
};

/** Collective: whether the value is true in some process. */
bool anyOf(Group& group, bool own);

/** The status of this process's part of a picture. */
struct PartStatus
{
  std::string Error;
  bool Stopped = false;
  bool TooMuch = false; // the visits of the band exceed their memory
  bool Waits = false;   // rays can continue after the exchange of hidden depths
  int Width = 0;
  int Height = 0;
};

/** Collective: the status of all. It has an error if some process has one, or if their pictures
 * differ in size; each other flag is set if it is set in some process. */
PartStatus agreeOn(Group& group, const PartStatus& own);

} // namespace tetmarch

#endif
