// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/TileSchedule.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetmarch
{
namespace
{

// Tiles of known cost aim below the limit, since their times vary; the others stay below twice the
// limit.
constexpr double Aim = 0.8;
constexpr double Most = 2.0;

// Maximum ratio of the time of a ray in a changed picture to that of the most expensive tile
// before: where opaque parts become transparent, rays become longer, and small objects can become
// large.
constexpr double MostDearer = 64;

// In seconds: faster rays may have hit nothing. It is half a draw call for the pixels of a tile.
constexpr double FastestRay = 5e-9;

constexpr int MostProbes = 8;
// From this number of tiles on, their maximum is representative of the picture.
constexpr int EnoughTiles = 8;
constexpr double Forgetting = 0.25; // of the most expensive tile, per picture

// The size of equal parts, each at most `most`.
int equalParts(int whole, std::int64_t most)
{
  const std::int64_t parts = (whole + most - 1) / most;
  return static_cast<int>((whole + parts - 1) / parts);
}

// A power of two.
int smallestSide(double raysPerPixel)
{
  constexpr int least = 8;
  constexpr double most = double(TileSchedule::SmallestSide) * TileSchedule::SmallestSide;
  int side = TileSchedule::SmallestSide;
  while (side > least && raysPerPixel * side * side > most)
  {
    side /= 2;
  }
  return side;
}

} // namespace

void TileSchedule::begin(int width, int height, double mostSeconds, const PictureContent& content)
{
  this->Width = std::max(width, 0);
  this->Height = this->Width > 0 ? std::max(height, 0) : 0;
  this->MostSeconds = mostSeconds;
  this->Content = content;
  this->Change = this->Past.Known ? content.changeFrom(this->Past.Content) : PictureChange::Another;
  this->Side = smallestSide(content.RaysPerPixel);
  this->Part = 0;
  this->X = this->Y = this->Tiles = 0;
  this->Given = this->Pixels = 0;
  this->Seconds = this->Slowest = this->Dearest = 0;
  this->Parts.clear();
  this->Probes = 0;
  const std::int64_t most = this->mostPixels();
  if (!this->Past.Known && most < this->area() && most > std::int64_t(this->Side) * this->Side)
  {
    this->scatterProbes();
  }
  else
  {
    this->Parts.push_back({ 0, 0, this->Width, this->Height });
  }
}

// One probe in each of several bands of rows.
void TileSchedule::scatterProbes()
{
  constexpr double GoldenRatio = 0.618034;
  const int bands = std::min(MostProbes, std::min(this->Width, this->Height) / (2 * this->Side));
  std::vector<Tile> rest;
  int y = 0;
  for (int i = 0; i < bands; ++i)
  {
    const double across = std::fmod(0.5 + i * GoldenRatio, 1.0);
    const int x = static_cast<int>(across * (this->Width - this->Side));
    const int row = static_cast<int>((i + 0.5) * this->Height / bands) - this->Side / 2;
    this->Parts.push_back({ x, row, this->Side, this->Side });
    rest.push_back({ 0, y, this->Width, row - y });
    rest.push_back({ 0, row, x, this->Side });
    rest.push_back({ x + this->Side, row, this->Width - x - this->Side, this->Side });
    y = row + this->Side;
  }
  rest.push_back({ 0, y, this->Width, this->Height - y });
  this->Probes = this->Parts.size();
  std::copy_if(rest.begin(), rest.end(), std::back_inserter(this->Parts),
    [](const Tile& part) { return part.pixels() > 0; });
}

// Whether previous pictures allow an estimate.
bool TileSchedule::isTrusted() const
{
  const bool seen = this->Past.Seen && this->Change != PictureChange::Another;
  return this->Past.Known && (seen || this->Past.Dearest >= FastestRay);
}

bool TileSchedule::fitsAsWhole() const
{
  const bool same = this->Change == PictureChange::None;
  if (!this->Past.Known || !(same || (this->Change == PictureChange::Part && this->isTrusted())))
  {
    return false;
  }
  const double exposed = this->Content.exposedSince(this->Past.Content);
  const double seconds =
    this->Past.SecondsPerPixel + exposed * this->Content.RaysPerPixel * this->Past.Dearest;
  return seconds * static_cast<double>(this->area()) <= this->MostSeconds;
}

// The expected time of a ray, for tiles of the maximum size within the limit.
double TileSchedule::secondsOfRay() const
{
  if (this->Past.Known && this->Change == PictureChange::None)
  {
    return this->Past.Slowest / Aim;
  }
  if (!this->isTrusted())
  {
    return WorstRaySeconds / Most;
  }
  const double dearest = this->Past.Dearest / Aim;
  return this->Change == PictureChange::Part
           ? dearest
           : std::max(dearest, std::min(MostDearer * this->Past.Dearest, WorstRaySeconds) / Most);
}

std::int64_t TileSchedule::mostPixels() const
{
  const std::int64_t area = this->area();
  if (!(this->MostSeconds > 0) || this->fitsAsWhole())
  {
    return area;
  }
  const double seconds =
    std::max(this->secondsOfRay(), this->Slowest / Aim) * this->Content.RaysPerPixel;
  const double most = seconds * static_cast<double>(area) > this->MostSeconds
                        ? this->MostSeconds / seconds
                        : static_cast<double>(area);
  return std::max(static_cast<std::int64_t>(most), std::int64_t(this->Side) * this->Side);
}

bool TileSchedule::next(Tile& tile)
{
  if (this->finished())
  {
    return false;
  }
  const Tile& part = this->Parts[this->Part];
  this->IsProbe = this->Part < this->Probes;
  const std::int64_t most = this->IsProbe ? part.pixels() : this->mostPixels();
  if (this->X == 0)
  {
    const std::int64_t rows = most / part.Width;
    const bool wide = rows >= this->Side / 2; // flat tiles are better than split ones
    this->Rows = equalParts(part.Height - this->Y, wide ? rows : this->Side);
  }
  const int columns =
    equalParts(part.Width - this->X, std::max<std::int64_t>(most / this->Rows, this->Side));
  tile = { part.X + this->X, part.Y + this->Y, columns, this->Rows };
  this->Last = tile;
  this->Given += tile.pixels();
  ++this->Tiles;
  this->X += columns;
  if (this->X == part.Width)
  {
    this->X = 0;
    this->Y += this->Rows;
  }
  if (this->Y == part.Height)
  {
    this->Y = 0;
    ++this->Part;
  }
  return true;
}

void TileSchedule::drawn(double seconds)
{
  // The time of the first tile may include the GL's compiler.
  const bool compiles = this->Tiles == 1 && this->Change == PictureChange::Another;
  if (!compiles)
  {
    const double least = static_cast<double>(this->Side) * this->Side;
    const auto ofRay = [&](double pixels)
    { return seconds / (std::max(pixels, least) * this->Content.RaysPerPixel); };
    this->Slowest = std::max(this->Slowest, ofRay(static_cast<double>(this->Last.pixels())));
    const double covered = this->coveredPixels(this->Last);
    if (covered > 0 && !this->IsProbe)
    {
      this->Dearest = std::max(this->Dearest, ofRay(covered));
    }
  }
  if (!compiles || this->finished())
  {
    this->Seconds += seconds;
    this->Pixels += this->Last.pixels();
  }
  if (this->finished())
  {
    this->complete();
  }
  else if (this->Change == PictureChange::None)
  {
    this->Past.Slowest =
      std::max(this->Past.Slowest, this->Slowest); // in case the picture is not completed
  }
}

// Of the tile, by the volume's bounding box.
double TileSchedule::coveredPixels(const Tile& tile) const
{
  const ScreenBox box = this->Content.box();
  const ScreenBox& drawn = this->Content.Drawn;
  const auto overlap = [&](int k, int begin, int size, int whole)
  {
    const double scale = whole / (drawn.High[k] - drawn.Low[k]);
    const double low = scale * (box.Low[k] - drawn.Low[k]);
    const double high = scale * (box.High[k] - drawn.Low[k]);
    return std::max(0.0, std::min<double>(high, begin + size) - std::max<double>(low, begin));
  };
  return overlap(0, tile.X, tile.Width, this->Width) *
         overlap(1, tile.Y, tile.Height, this->Height);
}

void TileSchedule::complete()
{
  const bool same = this->Past.Known && this->Change != PictureChange::Another;
  const double kept = this->Tiles >= EnoughTiles ? Forgetting : 1.0;
  this->Past.Seen = this->Content.showsWhole() || (same && this->Past.Seen);
  this->Past.Dearest = std::max(this->Dearest, kept * this->Past.Dearest);
  this->Past.Slowest = this->Slowest;
  this->Past.SecondsPerPixel = this->Seconds / static_cast<double>(this->Pixels);
  this->Past.Content = std::move(this->Content); // if memory is short, the picture is kept
  this->Past.Known = true;
}

double TileSchedule::share() const
{
  return this->area() > 0 ? static_cast<double>(this->Given) / static_cast<double>(this->area())
                          : 1.0;
}

} // namespace tetmarch
