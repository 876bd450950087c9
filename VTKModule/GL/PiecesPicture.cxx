// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PiecesPicture.h"

#include "Appearance/Blending.h"
#include "Caching/WithinMemory.h"
#include "Frame/FrameStages.h"
#include "Optics/IntegralTable.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// A quarter of a pixel's tolerance, as TOLERANCE_AT_ONCE in Shaders/gather/radiance.glsl.
constexpr float ToleranceAtOnce = 0.25f;

// Rays with more visits wait for what the others hide, then go on through twice as many, and so on.
constexpr int VisitsOfFirstTurn = 2;

MergeRule ruleOf(BlendGroup blend)
{
  return blend == BlendGroup::Extreme ? MergeRule::Greatest
         : blend == BlendGroup::Sum   ? MergeRule::Sum
                                      : MergeRule::Over;
}

// As tableValue() in Shaders/tables/integral_table.glsl.
std::array<float, 4> tableValue(const IntegralTable& table, double x)
{
  const double bin = std::max(0.0, std::min(std::floor(x), double(table.size() - 2)));
  const auto i = static_cast<std::size_t>(bin);
  const auto share = static_cast<float>(std::min(std::max(x - bin, 0.0), 1.0));
  std::array<float, 4> value;
  for (int k = 0; k < 4; ++k)
  {
    value[k] = table.Values[i][k] + (table.Values[i + 1][k] - table.Values[i][k]) * share;
  }
  return value;
}

// Premultiplied colour and opacity of what a pixel has gathered: pixelOf() of the blend modes in
// Shaders/gather. Sums come in the lengths that count.
void showColor(const MarchInputs& inputs, float* pixel)
{
  const FrameStages& stages = *inputs.Stages;
  if (inputs.Key.Blend == BlendGroup::Extreme)
  {
    const ScalarRange& range = stages.volume().range();
    const bool found = pixel[0] > emptyPixel(MergeRule::Greatest).Gathered[0];
    const double scalar = stages.blending().extremeSign() * pixel[0];
    const IntegralTable& table = stages.tables().first();
    const std::array<float, 4> value =
      tableValue(table, scalar * table.scale(range.width()) + table.offset(range.Low));
    pixel[3] = found ? value[3] : 0;
    std::transform(
      value.begin(), value.begin() + 3, pixel, [&](float color) { return color * pixel[3]; });
  }
  else if (inputs.Key.Blend == BlendGroup::Sum)
  {
    const bool counts = pixel[1] > 0;
    const float divisor = counts && stages.blending().Mode == BlendMode::Average ? pixel[1] : 1.0f;
    const float gray = counts && pixel[0] > 0 ? std::min(pixel[0] / divisor, 1.0f) : 0.0f;
    std::fill(pixel, pixel + 3, gray);
    pixel[3] = counts ? 1.0f : 0.0f;
  }
  else
  {
    pixel[3] = 1 - pixel[3];
  }
}

} // namespace

// March a turn of a band in this process, and see where the others are.
PartStatus PiecesPicture::march(const PiecesDraw& pieces, const VisitTurn& turn, VisitLists& lists)
{
  SharedPicture& shared = pieces.Shared;
  PartStatus own;
  own.Error = pieces.Before.Error;
  own.Stopped = pieces.Before.Stopped;
  const double begin = vtkTimerLog::GetUniversalTime();
  if (pieces.Before.isDone())
  {
    const std::string shortage = withinMemory("the visits of rays", [&]
      { own = this->Visits.collect(pieces.Context, pieces.March, pieces.Inputs, turn, lists); });
    own.Error = shortage.empty() ? own.Error : shortage;
    own.Waits = this->Visits.waits();
    this->Draws += this->Visits.takeDraws();
  }
  own.Width = pieces.Inputs.Area.Width;
  own.Height = pieces.Inputs.Area.Height;
  shared.MarchSeconds += vtkTimerLog::GetUniversalTime() - begin;
  shared.Visits += own.TooMuch ? 0 : lists.size();
  return agreeOn(*shared.Processes, own);
}

// Turn by turn, until no ray of any process waits for what the others hide.
PartStatus PiecesPicture::drawBand(
  const PiecesDraw& pieces, const Band& band, MergedPicture& merged)
{
  const MarchInputs& inputs = pieces.Inputs;
  SharedPicture& shared = pieces.Shared;
  Group& group = *shared.Processes;
  const MergeRule rule = ruleOf(inputs.Key.Blend);
  const int width = inputs.Area.Width;
  const int height = band.EndRow - band.FirstRow;
  VisitExchange exchange(
    group, width, height, rule, static_cast<float>(inputs.Level.ErrorTolerance), shared.Exchange);
  VisitTurn turn = this->firstTurn(pieces, band, rule == MergeRule::Over && group.size() > 1);
  this->Visits.begin(inputs.Area, band, shared.HasPiece);
  PartStatus all;
  std::vector<VisitLists> lists; // of each turn
  int visitsOfTurn = VisitsOfFirstTurn;
  bool goesOn = true;
  while (goesOn)
  {
    lists.emplace_back(width, height);
    all = this->march(pieces, turn, lists.back());
    if (!all.Error.empty() || all.Stopped || all.TooMuch)
    {
      return all;
    }
    exchange.add(lists.back());
    goesOn = all.Waits;
    if (goesOn)
    {
      visitsOfTurn *= 2;
      turn.MostVisits = visitsOfTurn;
      turn.Hidden = exchange.tellHidden();
      turn.HiddenIsSure = true;
      this->Visits.endHidden(turn.Hidden);
      goesOn = anyOf(group, this->Visits.waits());
    }
  }
  merged = exchange.spread();
  this->Expected.learn(band.FirstRow, turn.HiddenIsSure ? turn.Hidden : HiddenDepths());
  this->Expected.learn(band.FirstRow, merged.Hidden);
  this->Expected.count(band.FirstRow, lists, this->Visits.numberOfEnded());
  return all;
}

VisitTurn PiecesPicture::firstTurn(const PiecesDraw& pieces, const Band& band, bool canHide) const
{
  VisitTurn turn;
  turn.Hidden = canHide ? this->Expected.ofRows(band.FirstRow, band.EndRow) : HiddenDepths();
  const bool asks = canHide && turn.Hidden.empty();
  turn.MostVisits = asks ? VisitsOfFirstTurn : std::numeric_limits<int>::max();
  turn.AtOnce = ToleranceAtOnce / static_cast<float>(pieces.Shared.Processes->size());
  turn.MostBytes = pieces.Shared.MostBytes;
  return turn;
}

// Band by band, as many as the memory for the visits asks for.
PartStatus PiecesPicture::drawInBands(const PiecesDraw& pieces, MergedPicture& merged)
{
  const int height = pieces.Inputs.Area.Height;
  merged = {};
  merged.Width = pieces.Inputs.Area.Width;
  merged.Height = height;
  pieces.Shared.Visits = 0;
  PartStatus all;
  for (int b = 0; b < this->Bands; ++b)
  {
    const Band band{ height * b / this->Bands, height * (b + 1) / this->Bands };
    MergedPicture part;
    all = this->drawBand(pieces, band, part);
    if (!all.Error.empty() || all.Stopped || all.TooMuch)
    {
      return all;
    }
    merged.Gathered.insert(merged.Gathered.end(), part.Gathered.begin(), part.Gathered.end());
    merged.WorstError = std::max(merged.WorstError, part.WorstError);
  }
  return all;
}

StageResult PiecesPicture::draw(
  const PiecesDraw& pieces, const Viewport& area, PictureApart& picture)
{
  const MarchInputs& inputs = pieces.Inputs;
  SharedPicture& shared = pieces.Shared;
  this->Draws = 0;
  this->Bands = std::min(this->Bands, inputs.Area.Height);
  this->Expected.begin(inputs.Area.Width, inputs.Area.Height);
  MergedPicture merged;
  PartStatus all = this->drawInBands(pieces, merged);
  while (all.TooMuch && all.Error.empty() && !all.Stopped && this->Bands < inputs.Area.Height)
  {
    this->Bands = std::min(2 * this->Bands, inputs.Area.Height);
    all = this->drawInBands(pieces, merged);
  }
  shared.SentBytes = shared.Processes->sentBytes() - shared.SentBytesBefore;
  shared.WorstError = merged.WorstError;
  shared.Bands = this->Bands;
  if (!all.Error.empty() || all.Stopped)
  {
    return { all.Error, all.Stopped };
  }
  if (all.TooMuch)
  {
    return {
      "The visits of the rays of one row of pixels to the mesh of a process take more than " +
      std::to_string(shared.MostBytes >> 20) + " MiB. Give each process cells that lie together."
    };
  }
  for (std::size_t i = 0; i < merged.Gathered.size(); i += 4)
  {
    showColor(inputs, &merged.Gathered[i]);
  }
  return { picture.show(
    pieces.Context.Window, area, merged.Width, merged.Height, merged.Gathered) };
}

} // namespace tetmarch
