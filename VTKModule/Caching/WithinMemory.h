// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Turns a lack of memory into an error message.
#ifndef TetMarchCachingWithinMemory_h
#define TetMarchCachingWithinMemory_h

#include <new>
#include <stdexcept>
#include <string>

namespace tetmarch
{

/** Run work that may need much memory. Returns an empty string, or a message about the lack of
 * memory and its consequence. */
template <typename Work>
std::string withinMemory(
  const char* purpose, Work&& work, const char* consequence = "so nothing is drawn")
{
  try
  {
    work();
    return {};
  }
  catch (const std::bad_alloc&)
  {
  }
  catch (const std::length_error&)
  {
  }
  return std::string("The computer has too little memory for ") + purpose + ", " + consequence +
         ". Free some, or extract or coarsen a part of the grid.";
}

} // namespace tetmarch

#endif
