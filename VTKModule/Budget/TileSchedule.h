// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cuts a picture into tiles such that none takes longer than a limit, judged by what was drawn
// before.
#ifndef TetMarchBudgetTileSchedule_h
#define TetMarchBudgetTileSchedule_h

#include "Budget/PictureContent.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/** No ray is expected to take longer than this, in seconds, where nothing is known of it. */
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
 * A picture that fits the limit is one tile. Whether it fits is judged by the last picture, and by
 * the dearest tile of all of them:
 *
 * - If nothing has changed, the picture takes as long as the last one, in proportion to its size.
 * - If the camera has moved a little, or other parts of rays are drawn, so does all but what was
 *   not seen before. That may cost as much as the dearest tile.
 * - If anything else has changed, each ray may take 64 times as long as one of the dearest tile.
 * - If nothing is known, or nothing has been seen yet, each ray may take WorstRaySeconds. The first
 *   picture begins with small tiles, scattered over it.
 *
 * Unless a ray takes longer than that, no tile takes more than twice the limit. A tile that was
 * dearer than expected makes the following ones smaller. Tiles go from the bottom up, and span the
 * whole width as long as they can.
 */
class TileSchedule
{
public:
  /** In pixels: a side of at most this length is not cut, if a pixel is a ray. */
  static constexpr int SmallestSide = 32;

  /** Begin a picture. Without a limit in seconds (0) it is one tile. */
  void begin(int width, int height, double mostSeconds, const PictureContent& content);
  /** Get the next tile. False if the picture is complete. */
  bool next(Tile& tile);
  /** Tell how long the last tile of next() took. Its drawing must be finished (glFinish()). */
  void drawn(double seconds);
  /** The next picture is drawn by another GPU, or something else of which nothing is known. */
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
  std::vector<Tile> Parts; // of the picture: first the probes, one tile each, then the rest
  std::size_t Probes = 0;  // of them
  std::size_t Part = 0;    // that is being cut
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
  double Dearest = 0;      // the same of what the volume may cover of tiles that are no probes

  struct
  {
    bool Known = false;
    PictureContent Content;
    double SecondsPerPixel = 0;
    double Slowest = 0; // seconds a ray of its slowest tile
    double Dearest = 0; // the same of all pictures; it is forgotten slowly
    bool Seen = false;  // the whole volume was in a picture of this version
  } Past;               // the last picture that was completed
};

} // namespace tetmarch

#endif
