// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a tessellation by the places of their corners.
#ifndef TetMarchCurvedCornerCells_h
#define TetMarchCurvedCornerCells_h

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetmarch
{

class CornerCells
{
public:
  void add(std::uint32_t place, std::uint32_t cell) { this->Corners.emplace_back(place, cell); }

  /** After the last corner was added. */
  void sort() { std::sort(this->Corners.begin(), this->Corners.end()); }

  /** Calls back with each cell that has corners at all of these places. There must be a place. */
  template <typename Callback>
  void forEach(const std::vector<std::uint32_t>& places, const Callback& callback) const
  {
    const Corner last(places.front(), UINT32_MAX);
    for (auto at =
           std::lower_bound(this->Corners.begin(), this->Corners.end(), Corner(places.front(), 0));
         at != this->Corners.end() && *at <= last; ++at)
    {
      const auto isThere = [&](std::uint32_t place)
      {
        return std::binary_search(
          this->Corners.begin(), this->Corners.end(), Corner(place, at->second));
      };
      if (std::all_of(places.begin(), places.end(), isThere))
      {
        callback(at->second);
      }
    }
  }

private:
  using Corner = std::pair<std::uint32_t, std::uint32_t>; // a place and a cell
  std::vector<Corner> Corners;
};

} // namespace tetmarch

#endif
