// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/SentVisits.h"

namespace tetmarch
{

Bytes packVisits(const VisitLists& lists, int merger, int processes)
{
  Packer packer;
  std::vector<std::uint16_t> counts;
  const auto width = static_cast<std::uint32_t>(lists.width());
  for (int y = merger; y < lists.height(); y += processes)
  {
    const std::uint32_t begin = static_cast<std::uint32_t>(y) * width;
    const PixelSpan span =
      spanOf(width, [&](std::uint32_t x) { return lists.count(begin + x) > 0; });
    packer.add(&span, 1);
    counts.clear();
    for (std::uint32_t x = span.First; x < span.End; ++x)
    {
      if (lists.count(begin + x) > 0xffffu)
      {
        throw GroupFailure("A ray enters the piece of a process more than 65535 times.");
      }
      counts.push_back(static_cast<std::uint16_t>(lists.count(begin + x)));
    }
    packer.add(counts.data(), counts.size());
    if (span.First < span.End)
    {
      packer.add(lists.begin(begin + span.First),
        static_cast<std::size_t>(
          lists.end(begin + span.End - 1) - lists.begin(begin + span.First)));
    }
  }
  return std::move(packer.Packed);
}

SentRow takeRow(Unpacker& sent, std::uint32_t width)
{
  SentRow row;
  row.Where = takeSpan(sent, width);
  const auto counts = sent.takeVector<std::uint16_t>(row.Where.size());
  row.Starts.resize(counts.size() + 1, 0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    row.Starts[i + 1] = row.Starts[i] + counts[i];
  }
  row.Visits = sent.takeVector<Visit>(row.Starts.back());
  return row;
}

void SentRow::collect(std::uint32_t x, std::vector<Visit>& visits) const
{
  if (x >= this->Where.First && x < this->Where.End)
  {
    const std::uint32_t at = x - this->Where.First;
    visits.insert(visits.end(), this->Visits.begin() + this->Starts[at],
      this->Visits.begin() + this->Starts[at + 1]);
  }
}

} // namespace tetmarch
