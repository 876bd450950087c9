// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Divides a picture into tiles such that none exceeds a time limit, judged by previous draws.
#ifndef TetMarchBudgetTileSchedule_h
#define TetMarchBudgetTileSchedule_h

#include "Budget/PictureContent.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/** The assumed maximum time of a ray, in seconds, if nothing is known about it. */
constexpr double WorstRaySeconds = 20e-6;

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
 * A picture within the limit is one tile. This is estimated from the last picture, and from the
 * most expensive tile of all pictures:
 *
 * - If nothing has changed, the picture takes as long as the last one, in proportion to its size.
 * - If the camera has moved a little, or other parts of rays are drawn, the same holds for the part
 *   that was visible before. The new part may cost as much as the most expensive tile.
 * - If anything else has changed, each ray may take 64 times as long as one of that tile.
 * - If nothing is known, or nothing was visible before, each ray may take WorstRaySeconds. The
 * first picture begins with small tiles, scattered over it.
 *
 * Unless a ray takes longer than that, no tile exceeds twice the limit. A tile that took longer
 * than expected makes the following ones smaller. Tiles proceed from the bottom up, and span the
 * whole width if possible.
 */
class TileSchedule
{
public:
  /** In pixels: sides up to this length are not divided, with one ray per pixel. */
  static constexpr int SmallestSide = 32;

  /** Begin a picture. Without a limit in seconds (0) it is a single tile. */
  void begin(int width, int height, double mostSeconds, const PictureContent& content);
  /** Get the next tile. False if the picture is complete. */
  bool next(Tile& tile);
  /** Record the time of the last tile of next(). Its drawing must be finished (glFinish()). */
  void drawn(double seconds);
  /** Discard all times, for example for another GPU. */
  void forget() { this->Past = {}; }

  bool finished() const { return this->Given == this->area(); }
  int numberOfTiles() const { return this->Tiles; }
  /** Of the picture so far, 0..1. */
  double share() const;

private:
  std::int64_t area() const { return std::int64_t(this->Width) * this->Height; }
  bool isTrusted() const;
  bool fitsAsWhole() const;
  double secondsOfRay() const;
  std::int64_t mostPixels() const;
  double coveredPixels(const Tile& tile) const;
  void scatterProbes();
  void complete();

  int Width = 0;
  int Height = 0;
  double MostSeconds = 0;
  PictureContent Content;
  PictureChange Change = PictureChange::Another;
  int Side = SmallestSide; // of the smallest tiles
  std::vector<Tile> Parts; // of the picture: first the probes, one tile each, then the others
  std::size_t Probes = 0;  // of them
  std::size_t Part = 0;    // index of the part that is being divided
  int X = 0;               // the corner of the next tile in it
  int Y = 0;
  int Rows = 0; // of the tiles that begin at this Y
  Tile Last;
  bool IsProbe = false;   // the last tile
  std::int64_t Given = 0; // pixels of the tiles so far
  int Tiles = 0;
  double Seconds = 0;      // of the tiles that were measured
  std::int64_t Pixels = 0; // the same
  double Slowest = 0;      // seconds a ray of the slowest tile
  double Dearest = 0;      // the same for covered pixels of tiles other than probes

  struct
  {
    bool Known = false;
    PictureContent Content;
    double SecondsPerPixel = 0;
    double Slowest = 0; // seconds a ray of its slowest tile
    double Dearest = 0; // the same over all pictures, with slow decay
    bool Seen = false;  // the whole volume was in a picture of this version
  } Past;               // the last picture that was completed
};

} // namespace tetmarch

#endif
