// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The edges of a tessellation: which are halved, and where.
#ifndef TetMarchCurvedEdgeTable_h
#define TetMarchCurvedEdgeTable_h

#include "vtkType.h"

#include <cstdint>
#include <unordered_map>

namespace tetmarch
{

/** Between points of the output. */
class EdgeTable
{
public:
  static constexpr vtkIdType Whole = -1;
  static constexpr vtkIdType Unknown = -2;

  struct Edge
  {
    vtkIdType Middle = Unknown;  // the point, to be set if Unknown
    std::uint32_t Departure = 0; // of a Whole one, as numbered by EdgeDepartures
  };

  Edge& edge(vtkIdType a, vtkIdType b)
  {
    const auto low = static_cast<std::uint64_t>(a < b ? a : b);
    const auto high = static_cast<std::uint64_t>(a < b ? b : a);
    return this->Edges[low << 32 | high];
  }

private:
  struct Hash // SplitMix64, G. Steele et al., 2014
  {
    std::size_t operator()(std::uint64_t key) const
    {
      key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9U;
      key = (key ^ key >> 27) * 0x94d049bb133111ebU;
      return key ^ key >> 31;
    }
  };
  std::unordered_map<std::uint64_t, Edge, Hash> Edges;
};

} // namespace tetmarch

#endif
