// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of EntryLists.h within the texture buffer size of the GL.
#ifndef TetMarchEntriesEntryListLimit_h
#define TetMarchEntriesEntryListLimit_h

#include "Entries/EntryLists.h"

namespace tetmarch
{

/** As makeEntryLists(), but tiles are enlarged until neither array has more than mostTexels
 * elements, if there are no more faces than that. */
EntryLists makeEntryListsWithin(std::uint64_t mostTexels, const TetMesh& mesh,
  const std::vector<std::array<Id, 4>>& faces, const View& view, int width, int height);

} // namespace tetmarch

#endif
