// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/VisitExchange.h"

#include "vtkSMPTools.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cstring>

namespace tetmarch
{
namespace
{

class Packer
{
public:
  template <typename T>
  void add(const T* values, std::size_t count)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    this->Packed.insert(this->Packed.end(), bytes, bytes + count * sizeof(T));
  }
  Bytes Packed;
};

class Unpacker
{
public:
  explicit Unpacker(const Bytes& bytes)
    : Packed(bytes)
  {
  }
  template <typename T>
  void take(T* values, std::size_t count)
  {
    if (count * sizeof(T) > this->Packed.size() - this->At)
    {
      throw GroupFailure("What a process sent ends too early.");
    }
    if (count > 0)
    {
      std::memcpy(values, this->Packed.data() + this->At, count * sizeof(T));
    }
    this->At += count * sizeof(T);
  }

private:
  const Bytes& Packed;
  std::size_t At = 0;
};

// The pixels of a row from the first to before the last with visits.
struct Span
{
  std::uint32_t First, End;
};

Span spanOf(const VisitLists& lists, int row)
{
  const auto width = static_cast<std::uint32_t>(lists.width());
  const std::uint32_t begin = static_cast<std::uint32_t>(row) * width;
  Span span{ 0, width };
  while (span.First < span.End && lists.count(begin + span.First) == 0)
  {
    ++span.First;
  }
  while (span.End > span.First && lists.count(begin + span.End - 1) == 0)
  {
    --span.End;
  }
  return span;
}

// The visits that one process has sent, of one row at a time.
struct SentRow
{
  Span Where{ 0, 0 };
  std::vector<std::uint32_t> Starts; // in Visits, of each pixel of the span, and the end
  std::vector<Visit> Visits;
};

SentRow takeRow(Unpacker& sent, std::uint32_t width)
{
  SentRow row;
  sent.take(&row.Where, 1);
  if (row.Where.First > row.Where.End || row.Where.End > width)
  {
    throw GroupFailure("What a process sent is no row of the picture.");
  }
  std::vector<std::uint16_t> counts(row.Where.End - row.Where.First);
  sent.take(counts.data(), counts.size());
  row.Starts.resize(counts.size() + 1, 0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    row.Starts[i + 1] = row.Starts[i] + counts[i];
  }
  row.Visits.resize(row.Starts.back());
  sent.take(row.Visits.data(), row.Visits.size());
  return row;
}

void mergeRow(const std::vector<SentRow>& rows, std::uint32_t width, MergeRule rule, float opaque,
  MergedPixel* merged)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(width), 64,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<Visit> visits;
      for (vtkIdType x = first; x < last; ++x)
      {
        visits.clear();
        for (const SentRow& row : rows)
        {
          if (x >= row.Where.First && x < row.Where.End)
          {
            const std::uint32_t at = static_cast<std::uint32_t>(x) - row.Where.First;
            visits.insert(visits.end(), row.Visits.begin() + row.Starts[at],
              row.Visits.begin() + row.Starts[at + 1]);
          }
        }
        merged[x] = mergeVisits(visits, rule, opaque);
      }
    });
}

// The rows that this process merges, one after the other.
std::vector<MergedPixel> mergeOwnRows(const Group& group, const std::vector<Bytes>& incoming,
  int width, int height, MergeRule rule, float opaque)
{
  std::vector<Unpacker> sent(incoming.begin(), incoming.end());
  std::vector<MergedPixel> merged;
  std::vector<SentRow> rows(sent.size());
  for (int y = group.rank(); y < height; y += group.size())
  {
    for (std::size_t p = 0; p < sent.size(); ++p)
    {
      rows[p] = takeRow(sent[p], static_cast<std::uint32_t>(width));
    }
    merged.resize(merged.size() + width);
    mergeRow(rows, static_cast<std::uint32_t>(width), rule, opaque, &merged[merged.size() - width]);
  }
  return merged;
}

double secondsSince(double& time)
{
  const double now = vtkTimerLog::GetUniversalTime();
  const double seconds = now - time;
  time = now;
  return seconds;
}

} // namespace

Bytes packVisits(const VisitLists& lists, int merger, int processes)
{
  Packer packer;
  std::vector<std::uint16_t> counts;
  for (int y = merger; y < lists.height(); y += processes)
  {
    const std::uint32_t begin = static_cast<std::uint32_t>(y) * lists.width();
    const Span span = spanOf(lists, y);
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

MergedPicture mergeTogether(
  Group& group, const VisitLists& own, MergeRule rule, float opaque, ExchangeFigures& figures)
{
  double time = vtkTimerLog::GetUniversalTime();
  std::vector<Bytes> outgoing;
  for (int p = 0; p < group.size(); ++p)
  {
    outgoing.push_back(packVisits(own, p, group.size()));
  }
  const std::vector<Bytes> incoming = group.exchange(std::move(outgoing));
  figures.ExchangeSeconds += secondsSince(time);

  const std::vector<MergedPixel> rows =
    mergeOwnRows(group, incoming, own.width(), own.height(), rule, opaque);
  figures.MergeSeconds += secondsSince(time);

  Packer packer;
  packer.add(rows.data(), rows.size());
  const std::vector<Bytes> all = group.tellAll(packer.Packed);
  MergedPicture picture;
  picture.Width = own.width();
  picture.Height = own.height();
  picture.Gathered.resize(std::size_t(4) * own.width() * own.height());
  std::vector<MergedPixel> row(own.width());
  std::vector<Unpacker> parts(all.begin(), all.end());
  for (int y = 0; y < own.height(); ++y)
  {
    parts[mergerOf(y, group.size())].take(row.data(), row.size());
    float* to = &picture.Gathered[std::size_t(4) * y * own.width()];
    for (const MergedPixel& pixel : row)
    {
      to = std::copy(pixel.Gathered.begin(), pixel.Gathered.end(), to);
      picture.WorstError = std::max(picture.WorstError, pixel.Error);
    }
  }
  figures.SpreadSeconds += secondsSince(time);
  return picture;
}

} // namespace tetmarch
