// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a picture whose rays may enter a mesh.
#ifndef TetMarchEntriesEnteredPixels_h
#define TetMarchEntriesEnteredPixels_h

namespace tetmarch
{

struct EntryLists;

/** From Left and Bottom to before Right and Top. */
struct EnteredPixels
{
  int Left = 0;
  int Bottom = 0;
  int Right = 0;
  int Top = 0;
};

/** The smallest rectangle of tiles that includes all tiles with candidates. Its right and top tiles
 * may reach beyond the picture. */
EnteredPixels enteredPixels(const EntryLists& lists);

} // namespace tetmarch

#endif
