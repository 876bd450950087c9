// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Large arrays in large pages of memory.
#ifndef TetMarchParallelHugePages_h
#define TetMarchParallelHugePages_h

#include <cstddef>
#include <vector>

namespace tetmarch
{

/** Ask for large pages for memory that nobody has used yet. Without effect where the system has
 * none, or gives them to all (madvise(2), MADV_HUGEPAGE, of Linux). */
void preferHugePages(void* begin, std::size_t bytes);

/** A vector with room for `count` elements. In pages of 4 kB, the first use of a page takes about
 * as long as filling it, and each element that is read at random waits for the address of its page.
 */
template <typename T>
std::vector<T> roomFor(std::size_t count)
{
  std::vector<T> room;
  room.reserve(count);
  preferHugePages(room.data(), room.capacity() * sizeof(T));
  return room;
}

/** A vector of `count` elements of that value, with room as roomFor() makes it. */
template <typename T>
std::vector<T> filledWith(std::size_t count, const T& value = {})
{
  std::vector<T> filled = roomFor<T>(count);
  filled.resize(count, value);
  return filled;
}

} // namespace tetmarch

#endif
