// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/VolumeLight.h"

#include "Parallel/ParallelFor.h"
#include "Reference/LightRayCellKernel.h"
#include "Reference/LightRayConstantKernel.h"
#include "Reference/LightRayCornerGradientKernel.h"
#include "Reference/LightRayPointGradientKernel.h"
#include "Reference/LightRayPointKernel.h"
#include "Reference/LightRayTrilinearGradientKernel.h"
#include "Reference/LightRayTrilinearKernel.h"
#include "Reference/MakeKernel.h"
#include "Reference/ReferenceImage.h"

namespace tetmarch
{
namespace
{

template <typename Kernel, typename Real>
Kernel lightRayKernel(const ReferenceScene& scene, const AccuracyLevel& level)
{
  Kernel kernel = makeKernel<Kernel, Real>(*scene.Table, scene.Range, level);
  kernel.useScene(scene);
  kernel.lightTolerance = Real(LightTolerance);
  return kernel;
}

template <typename Kernel, typename Real>
std::vector<Real> atVertices(const ReferenceScene& scene)
{
  auto prototype = lightRayKernel<Kernel, Real>(scene, LightAccuracy);
  prototype.LightAtPoints = false;
  const auto count = scene.Cells ? static_cast<vtkIdType>(lightNodesOf(*scene.Cells).count())
                                 : static_cast<vtkIdType>(scene.Mesh->Vertices.size());
  std::vector<Real> light(4 * static_cast<std::size_t>(count));
  parallelFor(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      Kernel kernel = prototype;
      for (vtkIdType v = first; v < last; ++v)
      {
        const auto found = kernel.lightAtVertex(static_cast<Id>(v));
        light[4 * v] = found.x;
        light[4 * v + 1] = found.y;
        light[4 * v + 2] = found.z;
        light[4 * v + 3] = found.w;
      }
    });
  return light;
}

// Vertices are rounded to float: a point of the mesh's boundary may lie this far behind an opaque
// surface at the same place.
constexpr double OpaqueMargin = 1e-6;

template <typename Kernel, typename Real>
class ExactLight : public IncomingLight<Real>
{
public:
  using Vec3 = glsl::Vec3<Real>;

  explicit ExactLight(const ReferenceScene& scene)
    : Lights(scene.Effects->Lights)
    , Opaque(scene.Effects->Opaque)
    , March(lightRayKernel<Kernel, Real>(scene, ExactLightAccuracy))
  {
  }

  glsl::Vec4<Real> at(Vec3 point) const override
  {
    Real ambient = 0;
    const int directions = this->Lights.OcclusionDirections;
    for (int k = 0; k < directions; ++k)
    {
      ambient += this->transmittanceFrom(
        point, this->March.sphereDirection(k, directions), Real(this->Lights.OcclusionRadius));
    }
    std::array<Real, 3> light{ { 1, 1, 1 } };
    for (std::size_t i = 0; i < this->Lights.ShadowSources.size(); ++i)
    {
      const auto& source = this->Lights.ShadowSources[i];
      const Vec3 place{ Real(source[0]), Real(source[1]), Real(source[2]) };
      const Vec3 toLight = place - point * Real(source[3]);
      const Real far = std::sqrt(glsl::dot(toLight, toLight));
      const Real reach = Real(this->Lights.Reach);
      light[i] = this->isShadowed(point, i)
                   ? Real(0)
                   : this->transmittanceFrom(point, toLight * (Real(1) / far),
                       source[3] > 0 ? std::min(far, reach) : reach);
    }
    return { directions > 0 ? ambient / Real(directions) : Real(1), light[0], light[1], light[2] };
  }

private:
  bool isShadowed(Vec3 point, std::size_t source) const
  {
    return this->Opaque.isShadowed(
      { { double(point.x), double(point.y), double(point.z) } }, source, OpaqueMargin);
  }

  // Marches from the light to the point.
  Real transmittanceFrom(Vec3 point, Vec3 direction, Real distance) const
  {
    Kernel kernel = this->March;
    const auto ray = kernel.rayThrough(point, direction * Real(-1));
    const Real end = glsl::dot(point - ray.origin, ray.direction);
    const auto range = kernel.clippedRange(ray, { end - distance, end });
    const auto march =
      kernel.castPlainRay(ray, kernel.thicknessPerDepthAlong(direction), range.x, range.y);
    return range.x < range.y ? march.radiance.transmittance : Real(1);
  }

  const LightUniforms& Lights;
  const OpaqueShadows& Opaque;
  mutable Kernel March;
};

// Calls with an object of the kernel that marches rays towards the lights; its type is all that
// counts.
template <typename Real, typename Function>
auto byKernel(const ReferenceScene& scene, const Function& call)
{
  const bool ofCells = scene.Cells ? scene.Cells->Constant : scene.CellScalars != nullptr;
  const bool ofGradients = scene.Effects->CellGradients;
  if (scene.Cells)
  {
    return ofCells       ? call(LightRayConstantKernel<Real>())
           : ofGradients ? call(LightRayTrilinearGradientKernel<Real>())
                         : call(LightRayTrilinearKernel<Real>());
  }
  return ofCells               ? call(LightRayCellKernel<Real>())
         : scene.CornerScalars ? call(LightRayCornerGradientKernel<Real>())
         : ofGradients         ? call(LightRayPointGradientKernel<Real>())
                               : call(LightRayPointKernel<Real>());
}

} // namespace

template <typename Real>
std::vector<Real> lightAtVertices(const ReferenceScene& scene)
{
  return byKernel<Real>(
    scene, [&scene](auto kernel) { return atVertices<decltype(kernel), Real>(scene); });
}

template <typename Real>
std::unique_ptr<IncomingLight<Real>> exactLight(const ReferenceScene& scene)
{
  return byKernel<Real>(scene,
    [&scene](auto kernel) -> std::unique_ptr<IncomingLight<Real>>
    { return std::make_unique<ExactLight<decltype(kernel), Real>>(scene); });
}

template std::vector<float> lightAtVertices<float>(const ReferenceScene&);
template std::vector<double> lightAtVertices<double>(const ReferenceScene&);
template std::unique_ptr<IncomingLight<float>> exactLight<float>(const ReferenceScene&);
template std::unique_ptr<IncomingLight<double>> exactLight<double>(const ReferenceScene&);

} // namespace tetmarch
