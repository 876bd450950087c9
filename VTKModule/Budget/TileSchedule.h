// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cuts a picture into tiles such that none takes longer than a limit, judged by what was drawn
// before.
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
 * A picture that fits the limit is one tile. Whether it fits is judged by the last picture of the
 * same size; without one, the tiles begin small and grow. Tiles go from the bottom up, and span the
 * whole width as long as they can.
 */
class TileSchedule
{
public:
  /** In pixels: a side of at most this length is not cut. */
  static constexpr int SmallestSide = 32;

  /** Begin a picture. Without a limit in seconds (0) it is one tile. */
  void begin(int width, int height, double mostSeconds);
  /** Get the next tile. False if the picture is complete. */
  bool next(Tile& tile);
  /** Tell how long the last tile of next() took. Its drawing must be finished (glFinish()). */
  void drawn(double seconds);
  /** The next picture may take much longer than the last. */
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
  } Past; // the last picture that was completed
  bool Changed = false;
};

} // namespace tetmarch

#endif
