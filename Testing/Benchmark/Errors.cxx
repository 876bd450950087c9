// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include "Failure.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace tetmarch::bench
{
namespace
{
using testing::Image;

/// One above the other.
Image stacked(const Image& below, const Image& above)
{
  Image both = below;
  both.Height += above.Height;
  both.Rgba.insert(both.Rgba.end(), above.Rgba.begin(), above.Rgba.end());
  return both;
}

Image over(const Image& premultiplied, float gray)
{
  Image picture = premultiplied;
  for (std::size_t i = 0; i < picture.Rgba.size(); i += 4)
  {
    const float transmittance = 1.0F - premultiplied.Rgba[i + 3];
    for (std::size_t k = i; k < i + 3; ++k)
    {
      picture.Rgba[k] += transmittance * gray;
    }
  }
  return picture;
}

nlohmann::json inJson(const testing::Difference& difference)
{
  return { { "rms", difference.Rms }, { "p999", difference.Percentile999 },
    { "max", difference.Max } };
}

std::streamsize bytesOf(const Image& picture)
{
  return static_cast<std::streamsize>(sizeof(float) * picture.Rgba.size());
}
} // namespace

void writePicture(const std::string& file, const Image& picture)
{
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(picture.Rgba.data()), bytesOf(picture));
  if (!stream)
  {
    throw Failure("the reference picture can't be written to " + file);
  }
}

Image readReference(const std::string& file, const Image& other)
{
  Image picture(other.Width, other.Height);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(picture.Rgba.data()), bytesOf(picture));
  if (!stream || stream.peek() != std::ifstream::traits_type::eof())
  {
    throw Failure("there is no reference picture of that size in " + file);
  }
  return picture;
}

nlohmann::json errorsOf(const FloatPictures& pictures, const Image& reference)
{
  const float black[3] = { 0.0F, 0.0F, 0.0F };
  const float white[3] = { 1.0F, 1.0F, 1.0F };
  testing::Mask covered = testing::silhouette(reference, reference);
  const testing::Mask onBlack = testing::differsFrom(pictures.OnBlack, black);
  const testing::Mask onWhite = testing::differsFrom(pictures.OnWhite, white);
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    covered[i] = covered[i] || onBlack[i] || onWhite[i];
  }
  testing::Mask twice = covered;
  twice.insert(twice.end(), covered.begin(), covered.end());
  const testing::Difference difference =
    testing::compare(stacked(pictures.OnBlack, pictures.OnWhite),
      stacked(over(reference, 0.0F), over(reference, 1.0F)), twice, 0.0, testing::Channels::Rgb);
  return inJson(difference);
}

nlohmann::json errorsOnBlack(const Image& picture, const Image& reference)
{
  const float black[3] = { 0.0F, 0.0F, 0.0F };
  testing::Mask covered = testing::silhouette(reference, reference);
  const testing::Mask drawn = testing::differsFrom(picture, black);
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    covered[i] = covered[i] || drawn[i];
  }
  return inJson(
    testing::compare(picture, over(reference, 0.0F), covered, 0.0, testing::Channels::Rgb));
}
} // namespace tetmarch::bench
