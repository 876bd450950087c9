// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/TileSchedule.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

constexpr std::int64_t SmallestTile =
  std::int64_t(TileSchedule::SmallestSide) * TileSchedule::SmallestSide;

// Tiles aim below the limit, since their times differ.
constexpr double Aim = 0.8;

// For a picture of which nothing is known: sizes of the first two tiles and of the largest, since
// it may begin with an empty background.
constexpr int FirstShare = 64;
constexpr int LargestShare = 16;

// So many times as long a changed picture may take: where opaque things become transparent, rays go
// on.
constexpr double MostChange = 16;

// The size of equal parts, each at most `most`.
int equalParts(int whole, std::int64_t most)
{
  const std::int64_t parts = (whole + most - 1) / most;
  return static_cast<int>((whole + parts - 1) / parts);
}

} // namespace

void TileSchedule::begin(int width, int height, double mostSeconds)
{
  this->Width = std::max(width, 0);
  this->Height = this->Width > 0 ? std::max(height, 0) : 0;
  this->MostSeconds = mostSeconds;
  this->X = this->Y = this->Tiles = 0;
  this->Seconds = this->Slowest = 0;
  this->Pixels = 0;
  this->Known = this->isKnown();
}

bool TileSchedule::isKnown() const
{
  return this->Width == this->Past.Width && this->Height == this->Past.Height &&
         (!this->Changed || MostChange * this->Past.Seconds <= this->MostSeconds);
}

std::int64_t TileSchedule::mostPixels() const
{
  const std::int64_t area = std::int64_t(this->Width) * this->Height;
  if (!(this->MostSeconds > 0) || (this->Known && this->Past.Seconds <= this->MostSeconds))
  {
    return area;
  }
  const double slowest = std::max(this->Slowest, this->Known ? this->Past.Slowest : 0.0);
  std::int64_t most = area;
  if (slowest * static_cast<double>(area) > Aim * this->MostSeconds)
  {
    most = static_cast<std::int64_t>(Aim * this->MostSeconds / slowest);
  }
  if (!this->Known)
  {
    most = this->Tiles < 2 ? area / FirstShare
                           : std::min({ most, 2 * this->Last.pixels(), area / LargestShare });
  }
  return std::max(most, SmallestTile);
}

bool TileSchedule::next(Tile& tile)
{
  if (this->finished())
  {
    return false;
  }
  const std::int64_t most = this->mostPixels();
  if (this->X == 0)
  {
    const std::int64_t rows = most / this->Width;
    const bool wide = rows >= SmallestSide / 2; // flat tiles are better than cut ones
    this->Rows = equalParts(this->Height - this->Y, wide ? rows : SmallestSide);
  }
  const int columns =
    equalParts(this->Width - this->X, std::max<std::int64_t>(most / this->Rows, SmallestSide));
  tile = { this->X, this->Y, columns, this->Rows };
  this->Last = tile;
  ++this->Tiles;
  this->X += columns;
  if (this->X == this->Width)
  {
    this->X = 0;
    this->Y += this->Rows;
  }
  return true;
}

void TileSchedule::drawn(double seconds)
{
  // The first tile may have waited for the GL's compiler, too.
  const bool counts = this->Known || this->Tiles > 1 || this->finished();
  if (counts)
  {
    const std::int64_t pixels = std::max(this->Last.pixels(), SmallestTile);
    this->Slowest = std::max(this->Slowest, seconds / static_cast<double>(pixels));
    this->Seconds += seconds;
    this->Pixels += this->Last.pixels();
  }
  if (this->finished())
  {
    const double area = static_cast<double>(std::int64_t(this->Width) * this->Height);
    this->Past = { this->Width, this->Height,
      this->Seconds * area / static_cast<double>(this->Pixels), this->Slowest };
    this->Changed = false;
  }
  else if (this->Known)
  {
    this->Past.Slowest =
      std::max(this->Past.Slowest, this->Slowest); // in case the picture is left unfinished
  }
}

double TileSchedule::share() const
{
  const double rows = this->Height > 0 ? this->Height : 1;
  const double columns = this->Width > 0 ? this->Width : 1;
  return std::min(1.0, (this->Y + this->X * this->Rows / columns) / rows);
}

} // namespace tetmarch
