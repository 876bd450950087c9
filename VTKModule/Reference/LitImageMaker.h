// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Casts the rays of a whole image with effects of light.
#ifndef TetMarchReferenceLitImageMaker_h
#define TetMarchReferenceLitImageMaker_h

#include "Reference/ImageMaker.h"
#include "Reference/LitKernel.h"
#include "Reference/VolumeLight.h"

namespace tetmarch
{

template <typename Kernel, typename Real>
class LitImageMaker
{
public:
  LitImageMaker(const ReferenceScene& scene, const AccuracyLevel& level)
    : Maker(scene, level)
  {
    this->kernel().useEffects(*scene.Effects);
    if (scene.Effects->Lights.hasVolumeLight())
    {
      this->addVolumeLight(scene);
    }
  }

  Kernel& kernel() { return this->Maker.kernel(); }

  ReferenceImage make() { return this->Maker.make(); }

private:
  void addVolumeLight(const ReferenceScene& scene)
  {
    if (scene.ExactLight)
    {
      this->Exact = exactLight<Real>(scene);
      this->kernel().Incoming = this->Exact.get();
    }
    else
    {
      this->AtVertices = lightAtVertices<Real>(scene);
      this->kernel().VertexLight = this->AtVertices.data();
    }
  }

  ImageMaker<Kernel, Real> Maker;
  std::unique_ptr<IncomingLight<Real>> Exact;
  std::vector<Real> AtVertices;
};

} // namespace tetmarch

#endif
