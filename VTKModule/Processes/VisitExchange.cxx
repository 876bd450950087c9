// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/VisitExchange.h"

#include "Parallel/ParallelFor.h"
#include "Processes/SentVisits.h"

#include "vtkTimerLog.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

void mergeRow(
  const std::vector<SentRow>& rows, int width, MergeRule rule, float opaque, MergedPixel* merged)
{
  parallelFor(0, width, 64,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<Visit> visits;
      for (vtkIdType x = first; x < last; ++x)
      {
        visits.clear();
        for (const SentRow& row : rows)
        {
          row.collect(static_cast<std::uint32_t>(x), visits);
        }
        merged[x] = mergeVisits(visits, rule, opaque);
      }
    });
}

double secondsSince(double& time)
{
  const double now = vtkTimerLog::GetUniversalTime();
  const double seconds = now - time;
  time = now;
  return seconds;
}

} // namespace

VisitExchange::VisitExchange(
  Group& group, int width, int height, MergeRule rule, float opaque, ExchangeFigures& figures)
  : Processes(group)
  , Width(width)
  , Height(height)
  , Rule(rule)
  , Opaque(opaque)
  , Figures(figures)
{
  const int rows = (height - group.rank() + group.size() - 1) / group.size();
  this->Rows.resize(static_cast<std::size_t>(std::max(rows, 0)) * width, emptyPixel(rule));
}

void VisitExchange::add(const VisitLists& own)
{
  double time = vtkTimerLog::GetUniversalTime();
  std::vector<Bytes> outgoing;
  for (int p = 0; p < this->Processes.size(); ++p)
  {
    outgoing.push_back(packVisits(own, p, this->Processes.size()));
  }
  for (Bytes& incoming : this->Processes.exchange(std::move(outgoing)))
  {
    this->Received.push_back(std::move(incoming));
  }
  this->Figures.ExchangeSeconds += secondsSince(time);
  this->mergeOwnRows();
  this->Figures.MergeSeconds += secondsSince(time);
}

// Sequentially.
void VisitExchange::mergeOwnRows()
{
  std::vector<Unpacker> sent(this->Received.begin(), this->Received.end());
  std::vector<SentRow> rows(sent.size());
  for (int y = this->Processes.rank(); y < this->Height; y += this->Processes.size())
  {
    for (std::size_t i = 0; i < sent.size(); ++i)
    {
      rows[i] = takeRow(sent[i], static_cast<std::uint32_t>(this->Width));
    }
    mergeRow(rows, this->Width, this->Rule, this->Opaque, this->ownRow(y));
  }
}

HiddenDepths VisitExchange::tellHidden()
{
  double time = vtkTimerLog::GetUniversalTime();
  Packer packer;
  for (int y = this->Processes.rank(); y < this->Height; y += this->Processes.size())
  {
    packHidden(this->ownRow(y), this->Width, packer);
  }
  const std::vector<Bytes> all = this->Processes.tellAll(packer.Packed);
  std::vector<Unpacker> parts(all.begin(), all.end());
  HiddenDepths hidden(std::size_t(this->Width) * this->Height, NothingHidden);
  for (int y = 0; y < this->Height; ++y)
  {
    takeHidden(parts[mergerOf(y, this->Processes.size())], this->Width,
      &hidden[std::size_t(y) * this->Width]);
  }
  this->Figures.ExchangeSeconds += secondsSince(time);
  return hidden;
}

// Each process sends the maximum error of its rows; then for each row the pixels, a flag for hidden
// visits, and the hidden depths if it is set.
MergedPicture VisitExchange::spread()
{
  double time = vtkTimerLog::GetUniversalTime();
  Packer packer;
  float worst = 0;
  for (const MergedPixel& pixel : this->Rows)
  {
    worst = std::max(worst, pixel.Error);
  }
  packer.add(&worst, 1);
  for (int y = this->Processes.rank(); y < this->Height; y += this->Processes.size())
  {
    const MergedPixel* row = this->ownRow(y);
    std::for_each(row, row + this->Width,
      [&](const MergedPixel& pixel) { packer.add(pixel.Gathered.data(), 4); });
    const bool hides = std::any_of(
      row, row + this->Width, [](const MergedPixel& pixel) { return pixel.HiddenVisits > 0; });
    packer.add(&hides, 1);
    if (hides)
    {
      packHidden(row, this->Width, packer);
    }
  }
  MergedPicture picture = this->unpack(this->Processes.tellAll(packer.Packed));
  this->Figures.SpreadSeconds += secondsSince(time);
  return picture;
}

MergedPicture VisitExchange::unpack(const std::vector<Bytes>& all) const
{
  const std::size_t width = this->Width;
  MergedPicture picture;
  picture.Width = this->Width;
  picture.Height = this->Height;
  picture.Gathered.resize(4 * width * this->Height);
  std::vector<Unpacker> parts(all.begin(), all.end());
  for (Unpacker& part : parts)
  {
    float worst = 0;
    part.take(&worst, 1);
    picture.WorstError = std::max(picture.WorstError, worst);
  }
  for (int y = 0; y < this->Height; ++y)
  {
    Unpacker& part = parts[mergerOf(y, this->Processes.size())];
    part.take(&picture.Gathered[4 * width * y], 4 * width);
    bool hides = false;
    part.take(&hides, 1);
    if (hides)
    {
      picture.Hidden.resize(width * this->Height, NothingHidden);
      takeHidden(part, this->Width, &picture.Hidden[width * y]);
    }
  }
  return picture;
}

} // namespace tetmarch
