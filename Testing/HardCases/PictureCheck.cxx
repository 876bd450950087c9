// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureCheck.h"

#include "DisplacedMesh.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace tetmarch::testing
{
namespace
{
// In entries of the default level's table: what lies in one bin raises the ends of the bin, and by
// them the bins beside it, up to two entries away; elsewhere in the table by another amount.
constexpr double TableResolution = 2.0;

// In world coordinates.
std::array<double, 6> boundsOf(vtkUnstructuredGrid* grid, vtkMatrix4x4* matrix)
{
  double b[6];
  grid->GetBounds(b);
  std::array<double, 6> world{ { 1e300, -1e300, 1e300, -1e300, 1e300, -1e300 } };
  for (int corner = 0; corner < 8; ++corner)
  {
    const double in[4] = { b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)], 1.0 };
    double out[4];
    matrix->MultiplyPoint(in, out);
    for (int k = 0; k < 3; ++k)
    {
      world[2 * k] = std::min(world[2 * k], out[k]);
      world[2 * k + 1] = std::max(world[2 * k + 1], out[k]);
    }
  }
  return world;
}
} // namespace

PictureBounds boundsOfReference() { return {}; }

PictureBounds boundsOfGL()
{
  PictureBounds bounds;
  bounds.Reach = 0.01;
  return bounds;
}

PictureBounds boundsOfOthers()
{
  PictureBounds bounds;
  bounds.Channels = 3;
  bounds.Tolerance = 16.0 / 255.0;
  bounds.Reach = 0.5;
  bounds.Samples = 128;
  return bounds;
}

int sizeOf(const HardView& view) { return view.Pixels > 0 ? view.Pixels : HardPictureSize; }

void setUpHardCase(const HardCase& hard, const HardView& view, vtkUnstructuredGrid* grid,
  vtkRenderer* renderer, vtkVolume* volume)
{
  (hard.SetOptics ? hard.SetOptics : setStandardOptics)(volume->GetProperty(), grid);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(hard.Matrix.data());
  volume->SetUserMatrix(matrix);
  vtkCamera* camera = renderer->GetActiveCamera();
  view.Set(camera, grid);
  if (!view.KeepsClippingRange)
  {
    const auto bounds = boundsOf(grid, matrix);
    renderer->ResetCameraClippingRange(bounds.data());
  }
}

std::int64_t PictureResult::failures() const
{
  return this->Counters.Lost + this->Counters.Guarded + this->Counters.Refused + this->NotFinite +
         this->OutOfBound;
}

PictureCheck::PictureCheck(const HardCase& hard, const HardView& view)
  : Size(sizeOf(view))
  , Data(hard.Make())
{
  vtkDataArray* array = hard.CellScalars ? this->Data->GetCellData()->GetScalars()
                                         : this->Data->GetPointData()->GetScalars();
  setUpHardCase(hard, view, this->Data, this->Renderer, this->Volume);
  const FrameInput input{ { { this->Data }, { array, hard.CellScalars } }, this->Renderer,
    this->Volume };
  this->Frame = std::make_unique<FreshFrame>(input);
  this->AtDefault = this->Frame->at(DefaultAccuracy, this->Size, this->Size);
  this->AtReference = this->Frame->at(ReferenceAccuracy, this->Size, this->Size);
  const ReferenceImage image = this->AtReference->render<double>();
  this->GroundTruth = Image::fromFloats(this->Size, this->Size, image.Pixels.data());
}

Image PictureCheck::reference(MarchCounters& counters) const
{
  const ReferenceImage image = this->AtDefault->render<float>();
  counters = image.Counters;
  return Image::fromFloats(this->Size, this->Size, image.Pixels.data());
}

// One pixel of the ground truth. aside: how far the ray is moved, in pixels; entries: how far the
// transfer functions are moved at both ends of the range, in entries of the table.
std::array<float, 4> PictureCheck::pixelOf(const TetMesh& mesh, int x, int y,
  const std::array<double, 2>& aside, const std::array<double, 2>& entries) const
{
  ReferenceScene scene = this->AtReference->scene();
  scene.Mesh = &mesh;
  const IntegralTable& table = *this->AtDefault->scene().Table;
  const double entry = (table.End - table.Begin) / (table.size() - 5);
  scene.Range.Low += entries[0] * entry;
  scene.Range.High += entries[1] * entry;
  scene.Width = scene.Height = 1;
  const double centre[2] = { (2.0 * (x + aside[0]) + 1.0) / this->Size - 1.0,
    (2.0 * (y + aside[1]) + 1.0) / this->Size - 1.0 };
  auto& m = scene.Camera.ClipToNormalized;
  for (int r = 0; r < 4; ++r)
  {
    m[4 * r + 3] += centre[0] * m[4 * r] + centre[1] * m[4 * r + 1];
    m[4 * r] /= this->Size;
    m[4 * r + 1] /= this->Size;
  }
  const ReferenceImage image = renderReference<double>(scene, ReferenceAccuracy);
  return { { image.Pixels[0], image.Pixels[1], image.Pixels[2], image.Pixels[3] } };
}

bool PictureCheck::isWithinBounds(const Image& picture, int x, int y, const PictureBounds& bounds)
{
  if (this->Displaced.empty())
  {
    const TetMesh& mesh = this->Frame->volume().mesh();
    for (int i = 0; i < 64; ++i)
    {
      this->Displaced.push_back(
        i < DisplacementsTogether
          ? displacedTogether(mesh, VertexDisplacement, i)
          : displacedMesh(mesh, VertexDisplacement, static_cast<unsigned>(i)));
    }
  }
  const float* pixel = picture.pixel(x, y);
  std::array<float, 4> least, most;
  std::copy_n(this->GroundTruth.pixel(x, y), 4, least.begin());
  most = least;
  std::mt19937 random(71);
  const auto within1 = [&random] { return 2.0 * uniform(random) - 1.0; };
  for (int i = 0; i < bounds.Samples; ++i)
  {
    // At first only the geometry.
    const int meshes = static_cast<int>(this->Displaced.size());
    const double resolution = i < meshes ? 0.0 : TableResolution;
    const auto seen = this->pixelOf(this->Displaced[i % meshes], x, y,
      { { bounds.Reach * within1(), bounds.Reach * within1() } },
      { { resolution * within1(), resolution * within1() } });
    bool within = true;
    for (int k = 0; k < bounds.Channels; ++k)
    {
      least[k] = std::min(least[k], seen[k]);
      most[k] = std::max(most[k], seen[k]);
      within = within && double(pixel[k]) >= double(least[k]) - bounds.Tolerance &&
               double(pixel[k]) <= double(most[k]) + bounds.Tolerance;
    }
    if (within)
    {
      return true;
    }
  }
  // A ray within the surface may see any part of what there is.
  return bounds.Channels == 4 && least[3] == 0.0f && pixel[3] <= most[3];
}

PictureResult PictureCheck::compare(
  const Image& picture, const MarchCounters& counters, const PictureBounds& bounds)
{
  PictureResult result;
  result.Counters = counters;
  std::vector<double> errors;
  for (int y = 0; y < this->Size; ++y)
  {
    for (int x = 0; x < this->Size; ++x)
    {
      const float* pixel = picture.pixel(x, y);
      const float* expected = this->GroundTruth.pixel(x, y);
      bool finite = true;
      double worst = 0.0;
      for (int k = 0; k < bounds.Channels; ++k)
      {
        finite = finite && double(pixel[k]) >= -1e-6 && double(pixel[k]) <= 1.0 + 1e-5;
        worst = std::max(worst, std::abs(double(pixel[k]) - double(expected[k])));
      }
      result.NotFinite += finite ? 0 : 1;
      if (finite && worst > bounds.Tolerance)
      {
        result.OutOfBound += this->isWithinBounds(picture, x, y, bounds) ? 0 : 1;
      }
      result.WorstError = std::max(result.WorstError, worst);
      if (expected[3] > 0.0f || pixel[3] > 0.0f)
      {
        errors.push_back(worst);
      }
    }
  }
  if (!errors.empty())
  {
    const auto rank = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * double(errors.size()));
    std::nth_element(errors.begin(), rank, errors.end());
    result.TypicalError = *rank;
  }
  return result;
}
} // namespace tetmarch::testing
