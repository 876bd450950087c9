// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Into which tiles a picture is cut so that none takes longer than a limit, as far as what was
// drawn before tells.
#ifndef TetMarchBudgetTileSchedule_h
#define TetMarchBudgetTileSchedule_h

#include <cstdint>

namespace tetmarch
{

/** A part of a picture, in pixels from its lower left corner. */
struct Tile
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  std::int64_t pixels() const { return std::int64_t(this->Width) * this->Height; }
};

/**
 * A picture that fits the limit is one tile. Whether it does is known from the last picture of the
 * same size; if there is none, the tiles begin small and grow. Tiles go from the bottom up, over
 * the whole width as long as they can.
 */
class TileSchedule
{
public:
  /** Pixels; a side that is no longer is not cut. */
  static constexpr int SmallestSide = 32;

  /** Begin a picture; unless the limit in seconds is above 0, it is one tile. */
  void begin(int width, int height, double mostSeconds);
  /** The next tile; false if the picture is whole. */
  bool next(Tile& tile);
  /** What the tile took that next() gave last. Drawing must have ended: glFinish(). */
  void drawn(double seconds);
  /** Something else is drawn from now on, which may take much longer than what was. */
  void expectChange() { this->Changed = true; }

  bool finished() const { return this->Y >= this->Height; }
  int numberOfTiles() const { return this->Tiles; }
  /** Of the picture so far, 0..1. */
  double share() const;

private:
  bool isKnown() const;
  std::int64_t mostPixels() const;

  int Width = 0;
  int Height = 0;
  double MostSeconds = 0;
  int X = 0; // the corner of the next tile
  int Y = 0;
  int Rows = 0; // of the tiles that begin at this Y
  Tile Last;
  int Tiles = 0;
  bool Known = false;
  double Seconds = 0; // of the tiles that were measured
  std::int64_t Pixels = 0;
  double Slowest = 0; // seconds a pixel of the slowest tile

  struct
  {
    int Width = 0;
    int Height = 0;
    double Seconds = 0;
    double Slowest = 0;
  } Past; // the last picture that became whole
  bool Changed = false;
};

} // namespace tetmarch

#endif
