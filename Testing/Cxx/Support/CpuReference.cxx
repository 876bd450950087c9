// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CpuReference.h"

#include "Appearance/Components.h"
#include "Light/EffectStage.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/TetMeshBuilder.h"
#include "Reference/ReferenceImage.h"
#include "Volume/TetEffectSource.h"

#include <gtest/gtest.h>
#include <iostream>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
EffectOptions optionsOf(vtkTetMarchVolumeMapper* mapper)
{
  const int view = mapper->GetViewMode();
  return { mapper->GetGradientType() == vtkTetMarchVolumeMapper::CELL_GRADIENTS,
    static_cast<ShadowMethod>(mapper->GetShadowMethod()), mapper->GetVolumetricScatteringBlending(),
    mapper->GetGlobalIlluminationReach(), mapper->GetAmbientOcclusion(),
    mapper->GetAmbientOcclusionRadius(), mapper->GetAmbientOcclusionDirections(),
    mapper->GetOpaqueShadows(),
    view == vtkTetMarchVolumeMapper::VIEW_ILLUMINATION ? Subject::Illumination
    : view == vtkTetMarchVolumeMapper::VIEW_GRADIENTS  ? Subject::Gradients
                                                       : Subject::Picture,
    static_cast<BlendMode>(mapper->GetBlendMode()) };
}

// The stages before the GL, for the scene as it stands.
class ReferencePictureScene
{
public:
  ReferencePictureScene(Scene& scene, vtkVolumeProperty* property, const std::vector<float>& depths)
  {
    std::string error;
    if (buildTetMesh(scene.Data, {}, this->Mesh, error) != BuildStatus::Done)
    {
      throw std::runtime_error(error);
    }
    ensureHierarchy(this->Mesh);
    int cellFlag = 0;
    vtkDataArray* array = vtkAbstractMapper::GetScalars(scene.Data, scene.Mapper->GetScalarMode(),
      scene.Mapper->GetArrayAccessMode(), scene.Mapper->GetArrayId(), scene.Mapper->GetArrayName(),
      cellFlag);
    this->Level = levelOf(
      static_cast<Accuracy>(scene.Mapper->GetAccuracyLevel()), scene.Mapper->GetErrorTolerance());
    ReferenceScene& made = this->Made;
    DrawnScalars drawn;
    error = chooseScalars(scene.Data, array, cellFlag == 1,
      { VectorMode(scene.Mapper->GetVectorMode()), scene.Mapper->GetVectorComponent() },
      scene.property(), drawn);
    this->Scalars = readScalars(scene.Data, drawn, this->Mesh);
    this->Parts.Mix = drawn.Mix;
    this->Parts.FurtherRanges = this->Scalars.Further.Ranges;
    made.Range = this->Scalars.Range;
    made.CellScalars = cellFlag == 1 ? &this->Scalars.OfCells : nullptr;
    made.NanShown = scene.Mapper->GetDrawNanCells();
    this->Hidden = hiddenCells(scene.Data, this->Mesh);
    made.Hidden = property == scene.property() ? &this->Hidden : nullptr;
    const bool structured = scene.Mapper->GetOpacityLaw() == vtkTetMarchVolumeMapper::STRUCTURED;
    if (property == scene.property())
    {
      this->addBlending(scene);
    }
    const auto law = structured ? OpacityLaw::Structured : OpacityLaw::Unstructured;
    if (property == scene.property() && !this->Parts.isSingle())
    {
      this->Table = componentTables(property, law, made.Range, this->Level, this->Parts);
      error = setFactors(property, this->Parts);
      made.Parts = &this->Parts;
      made.Further = &this->Scalars.Further;
    }
    else
    {
      this->Table = blendedTable(property, law, this->Blend, made.Range, this->Level);
    }
    if (!makeView(scene.Renderer, scene.Volume, this->Mesh.Frame,
          property->GetScalarOpacityUnitDistance(), law, made.Camera))
    {
      throw std::runtime_error("the scene has no view");
    }
    error = makeClipping(clippingOf(scene.Mapper), scene.Volume, this->Mesh.Frame, made.Cut);
    if (!error.empty())
    {
      throw std::runtime_error(error);
    }
    if (property == scene.property())
    {
      this->addEffects(scene);
    }
    made.Mesh = &this->Mesh;
    made.Table = &this->Table;
    made.Width = scene.Renderer->GetSize()[0];
    made.Height = scene.Renderer->GetSize()[1];
    made.WindowDepths = depths.empty() ? nullptr : depths.data();
  }

  // Light through the volume as the GL has it, or computed in all places.
  ReferencePicture render(Precision precision, LightFrom light)
  {
    this->Made.ExactLight = light == LightFrom::Everywhere;
    const ReferenceImage image = precision == Precision::Double
                                   ? renderReference<double>(this->Made, this->Level)
                                   : renderReference<float>(this->Made, this->Level);
    return { Image::fromFloats(this->Made.Width, this->Made.Height, image.Pixels.data()),
      image.ErrorBounds, image.Counters };
  }

private:
  void addBlending(Scene& scene)
  {
    const double* range = scene.Mapper->GetAverageIPScalarRange();
    const std::string error =
      makeBlending({ scene.Mapper->GetBlendMode(), { { range[0], range[1] } } }, scene.property(),
        this->Made.Range, this->Blend);
    if (!error.empty())
    {
      throw std::runtime_error(error);
    }
    this->Made.Blend = &this->Blend;
  }

  void addEffects(Scene& scene)
  {
    const Fingerprint version{ 1 };
    const TetEffectSource source(this->Mesh, this->Scalars.OfCells, this->Scalars.Range, version);
    const std::string error =
      this->Effects.update(scene.Renderer, scene.Volume, optionsOf(scene.Mapper), { &source });
    if (!error.empty())
    {
      throw std::runtime_error(error);
    }
    this->Made.Effects = &this->Effects.data();
  }

  TetMesh Mesh;
  MeshScalars Scalars;
  HiddenCells Hidden;
  IntegralTable Table;
  Components Parts;
  Blending Blend;
  EffectStage Effects;
  AccuracyLevel Level = DefaultAccuracy;
  ReferenceScene Made;
};

Difference compareInside(
  const char* what, const Image& drawn, const Image& reference, const Mask& inside)
{
  const Difference difference = compare(drawn, reference, inside);
  EXPECT_LE(difference.Max, 2.0 / 255.0) << what << ": " << difference.text();
  EXPECT_LE(difference.Rms, 0.3 / 255.0) << what << ": " << difference.text();
  std::cout << "[ MEASURED ] inside, " << what << ": " << difference.text() << '\n';
  return difference;
}

void expectCounters(const vtkTetMarchVolumeMapper* mapper)
{
  // The rasteriser's rounding: searched for.
  EXPECT_LE(mapper->GetNumberOfRefusedEntries(), 20);
  EXPECT_EQ(mapper->GetNumberOfLostRays(), 0);
  EXPECT_EQ(mapper->GetNumberOfGuardHits(), 0);
  EXPECT_GT(mapper->GetNumberOfRays(), 100);
  EXPECT_GE(mapper->GetNumberOfCrossedCells(), mapper->GetNumberOfRays());
  EXPECT_GT(mapper->GetNumberOfLookups(), 100);
}

void expectAgreement(Scene& scene, const Image& drawn, const std::vector<float>& depths)
{
  expectCounters(scene.Mapper);
  const ReferencePicture reference = referenceOf(scene, depths);
  const Regions regions = regionsOf(scene, depths);
  const Difference inside = compareInside("double", drawn, reference.Picture, regions.Inside);
  EXPECT_GT(inside.Pixels, 400u);
  compareInside(
    "float", drawn, referenceOf(scene, depths, Precision::Float).Picture, regions.Inside);

  const Image nothing(drawn.Width, drawn.Height);
  EXPECT_EQ(compare(drawn, nothing, regions.Outside, 0.0).Over, 0u) << "something outside";
  const Difference rim = compare(drawn, reference.Picture, regions.Rim);
  EXPECT_LE(50 * rim.Over, rim.Pixels) << "rim: " << rim.text();
  std::cout << "[ MEASURED ] rim: " << rim.text() << "; rays " << scene.Mapper->GetNumberOfRays()
            << " (reference " << reference.Counters.Rays << "), cells "
            << scene.Mapper->GetNumberOfCrossedCells() << " (reference " << reference.Counters.Cells
            << ")\n";
}
} // namespace

ClippingOptions clippingOf(vtkTetMarchVolumeMapper* mapper)
{
  ClippingOptions options;
  options.Planes = mapper->GetClippingPlanes();
  options.Cropping = mapper->GetCropping();
  mapper->GetCroppingRegionPlanes(options.CroppingPlanes.data());
  options.CroppingFlags = mapper->GetCroppingRegionFlags();
  return options;
}

ReferencePicture referenceOf(
  Scene& scene, const std::vector<float>& depths, Precision precision, LightFrom light)
{
  return ReferencePictureScene(scene, scene.property(), depths).render(precision, light);
}

Regions regionsOf(Scene& scene, const std::vector<float>& depths)
{
  // Thin fog shows every chord, and nothing ends early in it.
  vtkNew<vtkVolumeProperty> fog;
  setPlainFunctions(fog, { 1.0, 1.0, 1.0 }, 0.01);
  fog->GetRGBTransferFunction()->SetNanColorRGBA(1.0, 1.0, 1.0, 0.01);
  fog->SetScalarOpacityUnitDistance(scene.Data->GetLength());
  const Image seen = ReferencePictureScene(scene, fog, depths)
                       .render(Precision::Double, LightFrom::Vertices)
                       .Picture;

  Regions regions;
  for (int y = 0; y < seen.Height; ++y)
  {
    for (int x = 0; x < seen.Width; ++x)
    {
      bool all = true;
      bool any = false;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, seen.Height - 1); ++v)
      {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, seen.Width - 1); ++u)
        {
          const bool covered = seen.pixel(u, v)[3] > 0.0f;
          all = all && covered;
          any = any || covered;
        }
      }
      regions.Inside.push_back(all);
      regions.Outside.push_back(!any);
      regions.Rim.push_back(any && !all);
    }
  }
  return regions;
}

void expectParity(Scene& scene, const std::vector<float>& depths)
{
  const Image drawn = scene.render();
  expectAgreement(scene, drawn, depths);
}

void expectParityWithOpaque(Scene& scene)
{
  const Image drawn = scene.render();
  expectAgreement(scene, drawn, scene.windowDepths());
}

void expectLightAlongRays(Scene& scene, const Image& drawn, const Image& without)
{
  const Difference difference =
    compare(drawn, referenceOf(scene, {}, Precision::Double, LightFrom::Everywhere).Picture,
      regionsOf(scene).Inside);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_GT(difference.Pixels, 200u);
  EXPECT_LE(difference.Rms, 1.5 / 255.0);
  EXPECT_GT(compare(drawn, without).Max, 0.02);
}
} // namespace tetmarch::testing
