// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture that several processes draw together.
#ifndef TetMarchProcessesSharedPicture_h
#define TetMarchProcessesSharedPicture_h

#include "Processes/VisitExchange.h"

namespace tetmarch
{

/** Who draws it, and what that took of this process. */
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
  double WorstError = 0;             // of all pixels: how far a channel may be off
};

/** Collective: whether some process says so. */
bool anyOf(Group& group, bool own);

/** Where this process is with its part of a picture. */
struct PartStatus
{
  std::string Error;
  bool Stopped = false;
  bool TooMuch = false; // the visits of the band take more memory than there is for them
  bool Waits = false;   // rays may go on when all have told what they hide
  int Width = 0;
  int Height = 0;
};

/** Collective: the status of all. It has an error if some process has one, or if their pictures
 * differ in size; it is stopped, or too much, or waits, if one does. */
PartStatus agreeOn(Group& group, const PartStatus& own);

} // namespace tetmarch

#endif
