// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The visits of rays to the pieces of a volume.
#ifndef TetMarchProcessesVisits_h
#define TetMarchProcessesVisits_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** The part of a ray between entering a piece and leaving it. Depths are those along the ray in the
 * normalised frame of the whole volume, and so are comparable between processes. */
struct Visit
{
  float Begin, End;
  /** Emission and absorption, or surfaces: premultiplied red, green, blue, and the transmittance
   * 0..1 of this part only. Extremes: the scalar and three zeros. Sums: the sum, the length that
   * counts, and two zeros. */
  std::array<float, 4> Gathered;
  float Error; // error bound of each channel of this part
};

/** The rule by which visits are merged. */
enum class MergeRule
{
  Over,     // front to back
  Greatest, // of the first number
  Sum
};

/** The visits of the pixels of a picture, front to back in each pixel. */
class VisitLists
{
public:
  VisitLists() = default;
  VisitLists(int width, int height)
    : Width(width)
    , Height(height)
  {
  }

  int width() const { return this->Width; }
  int height() const { return this->Height; }
  /** Pixels are counted from the lower left, row by row. The visits of a pixel must be added in
   * their order; those of other pixels may come between them. */
  void add(std::uint32_t pixel, const Visit& visit)
  {
    this->Pixels.push_back(pixel);
    this->Added.push_back(visit);
  }
  /** Build the lists of the added visits. */
  void finish();

  std::size_t size() const { return this->Added.size(); }
  std::size_t bytes() const { return this->Added.size() * (sizeof(Visit) + sizeof(std::uint32_t)); }
  const Visit* begin(std::uint32_t pixel) const { return this->Added.data() + this->Starts[pixel]; }
  const Visit* end(std::uint32_t pixel) const
  {
    return this->Added.data() + this->Starts[pixel + 1];
  }
  std::uint32_t count(std::uint32_t pixel) const
  {
    return this->Starts[pixel + 1] - this->Starts[pixel];
  }

private:
  int Width = 0;
  int Height = 0;
  std::vector<std::uint32_t> Pixels;
  std::vector<Visit> Added;
  std::vector<std::uint32_t> Starts; // of each pixel's list, and the end of the last
};

/** Deeper than any visit. */
constexpr float NothingHidden = 3e38f;

/** The merged values of a pixel, in the form of Visit::Gathered, and their error bound. */
struct MergedPixel
{
  std::array<float, 4> Gathered;
  float Error;
  float HiddenFrom = NothingHidden; // everything behind this depth is invisible
  std::uint32_t HiddenVisits = 0;   // that were left out
};

/** An empty pixel. */
MergedPixel emptyPixel(MergeRule rule);

/** Merge the sorted visits of one pixel. Visits behind a transmittance below `opaque` are left out,
 * and this transmittance is added to the error. */
MergedPixel mergeVisits(std::vector<Visit>& visits, MergeRule rule, float opaque);

} // namespace tetmarch

#endif
