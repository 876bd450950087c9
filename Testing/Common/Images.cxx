// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
void requireSameSize(const Image& a, const Image& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    throw std::invalid_argument("the images differ in size");
  }
}

double apart(float a, float b)
{
  const double difference = std::abs(static_cast<double>(a) - static_cast<double>(b));
  return std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
}
} // namespace

Image::Image(int width, int height)
  : Width(width)
  , Height(height)
  , Rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f)
{
}

Image Image::fromBytes(int width, int height, const unsigned char* rgba)
{
  Image image(width, height);
  std::transform(rgba, rgba + image.Rgba.size(), image.Rgba.begin(),
    [](unsigned char byte) { return static_cast<float>(byte) / 255.0f; });
  return image;
}

Image Image::fromFloats(int width, int height, const float* rgba)
{
  Image image(width, height);
  std::copy(rgba, rgba + image.Rgba.size(), image.Rgba.begin());
  return image;
}

float* Image::pixel(int x, int y)
{
  return &this->Rgba[4 * (static_cast<std::size_t>(y) * this->Width + x)];
}

const float* Image::pixel(int x, int y) const
{
  return &this->Rgba[4 * (static_cast<std::size_t>(y) * this->Width + x)];
}

Mask silhouette(const Image& a, const Image& b, float alpha)
{
  requireSameSize(a, b);
  Mask mask(a.Rgba.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    // A NaN belongs to the silhouette: compare() must see it.
    mask[i] = !(a.Rgba[4 * i + 3] <= alpha && b.Rgba[4 * i + 3] <= alpha);
  }
  return mask;
}

Mask differsFrom(const Image& image, const float background[3], float threshold)
{
  Mask mask(image.Rgba.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      mask[i] = mask[i] || !(std::abs(image.Rgba[4 * i + c] - background[c]) <= threshold);
    }
  }
  return mask;
}

Difference compare(
  const Image& a, const Image& b, const Mask& mask, double threshold, Channels channels)
{
  requireSameSize(a, b);
  const int count = static_cast<int>(channels);
  const std::size_t pixels = a.Rgba.size() / 4;
  if (!mask.empty() && mask.size() != pixels)
  {
    throw std::invalid_argument("the mask differs in size from the images");
  }
  Difference result;
  std::vector<double> worst;
  double squares = 0.0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (!mask.empty() && !mask[i])
    {
      continue;
    }
    double here = 0.0;
    for (int c = 0; c < count; ++c)
    {
      const double difference = apart(a.Rgba[4 * i + c], b.Rgba[4 * i + c]);
      squares += difference * difference;
      here = std::max(here, difference);
    }
    worst.push_back(here);
    result.Over += here > threshold;
    if (here > result.Max || result.WorstX < 0)
    {
      result.Max = here;
      result.WorstX = static_cast<int>(i % a.Width);
      result.WorstY = static_cast<int>(i / a.Width);
    }
  }
  result.Pixels = worst.size();
  if (!worst.empty())
  {
    result.Rms = std::sqrt(squares / (static_cast<double>(worst.size()) * count));
    const auto rank = worst.begin() + (worst.size() - 1 - worst.size() / 1000);
    std::nth_element(worst.begin(), rank, worst.end());
    result.Percentile999 = *rank;
  }
  return result;
}

std::string Difference::text() const
{
  std::ostringstream line;
  line << "max " << 255.0 * this->Max << "/255 at (" << this->WorstX << ", " << this->WorstY
       << "), RMS " << 255.0 * this->Rms << "/255, 99.9 % within " << 255.0 * this->Percentile999
       << "/255, " << this->Over << " over the threshold, of " << this->Pixels << " pixels";
  return line.str();
}

Image differenceImage(const Image& a, const Image& b, float gain)
{
  requireSameSize(a, b);
  Image image(a.Width, a.Height);
  for (std::size_t i = 0; i < image.Rgba.size(); ++i)
  {
    const double shown = static_cast<double>(gain) * apart(a.Rgba[i], b.Rgba[i]);
    image.Rgba[i] = i % 4 == 3 ? 1.0f : static_cast<float>(std::min(shown, 1.0));
  }
  return image;
}

bool writePng(const Image& image, const std::string& fileName, Channels channels)
{
  const int count = static_cast<int>(channels);
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.Width, image.Height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, count);
  auto* bytes = static_cast<unsigned char*>(data->GetScalarPointer());
  for (std::size_t i = 0; i < image.Rgba.size() / 4; ++i)
  {
    for (int c = 0; c < count; ++c)
    {
      // A NaN becomes 0.
      const float value = image.Rgba[4 * i + c];
      const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
      bytes[count * i + c] = static_cast<unsigned char>(std::lround(255.0f * clamped));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(data);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
} // namespace tetmarch::testing
