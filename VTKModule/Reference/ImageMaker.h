// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Casts the rays of a whole image, in parallel, by one kernel.
#ifndef TetMarchReferenceImageMaker_h
#define TetMarchReferenceImageMaker_h

#include "Reference/MakeKernel.h"
#include "Reference/RayTrace.h"
#include "Reference/ReferenceImage.h"
#include "Reference/RowPortions.h"
#include "Reference/ThicknessPerDepth.h"
#include "Reference/VolumeLight.h"
#include "View/BlueNoise.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

namespace tetmarch
{

template <typename Real>
glsl::Vec3<Real> toVec(const std::array<double, 3>& v)
{
  return { Real(v[0]), Real(v[1]), Real(v[2]) };
}

template <template <typename> class KernelOf, typename Real>
class ImageMaker
{
  using Kernel = KernelOf<Real>;

public:
  ImageMaker(const ReferenceScene& scene, const AccuracyLevel& level)
    : Scene(scene)
    , March(makeKernel<Kernel, Real>(*scene.Table, scene.Range, level))
  {
    this->March.useScene(scene);
    if constexpr (Kernel::HasLightAtPoints)
    {
      this->March.lightTolerance = Real(std::max(level.ErrorTolerance, LightTolerance));
    }
    if constexpr (Kernel::HasVolumeLight)
    {
      this->useVolumeLight();
    }
    const std::size_t pixels = std::size_t(scene.Width) * scene.Height;
    this->Image.Pixels.assign(4 * pixels, 0.0f);
    this->Image.ErrorBounds.assign(pixels, 0.0f);
  }

  ReferenceImage make()
  {
    if (this->Scene.Trace)
    {
      this->tracePixel(*this->Scene.Trace);
      return std::move(this->Image);
    }
    this->Image.Stopped = !forRows(this->Scene.Height, this->Scene.Report,
      [this](vtkIdType first, vtkIdType last) { this->castRows(first, last); });
    return std::move(this->Image);
  }

private:
  void castRows(vtkIdType first, vtkIdType last)
  {
    Kernel kernel = this->March;
    MarchCounters counters;
    for (vtkIdType row = first; row < last; ++row)
    {
      for (int column = 0; column < this->Scene.Width; ++column)
      {
        this->castPixel(kernel, column, static_cast<int>(row), counters);
      }
    }
    this->add(counters);
  }

  void tracePixel(RayTrace& trace)
  {
    this->March.Trace = &trace;
    this->castPixel(this->March, trace.X, trace.Y, this->Image.Counters);
  }

  void useVolumeLight()
  {
    if (!this->Scene.Effects->Lights.hasVolumeLight())
    {
      return;
    }
    if (this->Scene.Light != LightAt::Vertices)
    {
      this->Exact = exactLight<Real>(this->Scene);
      this->March.Incoming = this->Exact.get();
    }
    else
    {
      this->AtVertices = lightAtVertices<Real>(this->Scene);
      this->March.VertexLight = this->AtVertices.data();
    }
  }

  void castPixel(Kernel& kernel, int column, int row, MarchCounters& counters)
  {
    const View& view = this->Scene.Camera;
    const std::size_t pixel = std::size_t(row) * this->Scene.Width + column;
    const double x = (column + 0.5) / this->Scene.Width * 2 - 1;
    const double y = (row + 0.5) / this->Scene.Height * 2 - 1;
    const double depth = this->Scene.WindowDepths ? double(this->Scene.WindowDepths[pixel]) : 1.0;
    const auto nearest = toVec<double>(view.unproject(x, y, -1));
    const auto farthest = toVec<double>(view.unproject(x, y, 2 * depth - 1));
    const glsl::Vec3<double> eye{ view.Eye[0], view.Eye[1], view.Eye[2] };
    const auto away = glsl::normalize(nearest * view.Eye[3] - eye);
    // The point of the ray nearest the centre has the least rounding error.
    const auto near0 = nearest - away * glsl::dot(nearest, away);
    auto ray = kernel.rayThrough({ Real(near0.x), Real(near0.y), Real(near0.z) },
      { Real(away.x), Real(away.y), Real(away.z) });
    const auto seen =
      kernel.clippedRange(ray, { Real(glsl::dot(nearest, away)), Real(glsl::dot(farthest, away)) });
    const Real thickness = thicknessPerDepth<Real>(view, ray.direction);
    kernel.beginTrace(nearest, away, seen, thickness);
    if (!(seen.x < seen.y))
    {
      return;
    }
    if constexpr (Kernel::TakesSamples)
    {
      const auto shift = this->Scene.Samples.shift();
      const float noise = blueNoiseAt(column, row);
      kernel.placeSamples(seen.x, ray);
      kernel.shiftSamples(Real(noise * shift[0] + shift[1]), ray);
    }
    const auto march = kernel.castPlainRay(ray, thickness, seen.x, seen.y);
    kernel.endTrace(march);

    float* rgba = &this->Image.Pixels[4 * pixel];
    const auto color = kernel.pixelOf(march.radiance, thickness);
    rgba[0] = float(color.x);
    rgba[1] = float(color.y);
    rgba[2] = float(color.z);
    rgba[3] = float(color.w);
    this->Image.ErrorBounds[pixel] = float(kernel.errorBound(march.radiance));
    counters += { march.cells > 0 ? 1 : 0, march.cells, march.lookups, march.refused, march.lost,
      march.guarded };
  }

  void add(const MarchCounters& counters)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Image.Counters += counters;
  }

  const ReferenceScene& Scene;
  Kernel March;
  std::unique_ptr<IncomingLight<Real>> Exact;
  std::vector<Real> AtVertices; // the light there
  ReferenceImage Image;
  std::mutex Mutex;
};

template <template <typename> class KernelOf, typename Real>
ReferenceImage makeImage(const ReferenceScene& scene, const AccuracyLevel& level)
{
  return ImageMaker<KernelOf, Real>(scene, level).make();
}

} // namespace tetmarch

#endif
