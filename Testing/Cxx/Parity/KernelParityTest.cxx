// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Each kernel of the CPU reference beside the GL. A scene gets the features of the kernel's key, is
// drawn, and is marched pixel by pixel by that kernel. Reference/Kernels.cmake makes the table of
// kernels, so a new one is tested at once.
#include "ComponentScene.h"
#include "CutScene.h"
#include "GLObjects.h"
#include "Lights.h"
#include "Reference/KernelTable.h"
#include "ScenePage.h"
#include "StructuredScene.h"
#include "Variants/VariantKey.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <set>

namespace
{
using namespace tetmarch::testing;
using tetmarch::PictureKernel;
using tetmarch::VariantKey;
using Mapper = vtkTetMarchVolumeMapper;

// All rays meet the volume. The GL rounds as the kernel in float does, but for gradients and light
// at vertices, which it keeps in fewer bits, and for where it enters tetrahedra.
constexpr int Width = 6;
constexpr int Height = 4;
constexpr double MostError = 0.2 / 255.0;

bool isOf(const PictureKernel& kernel, const std::string& name)
{
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    if (feature.Name == name)
    {
      return (kernel.Chosen & feature.Bit) != 0;
    }
  }
  throw std::logic_error("no feature is called " + name);
}

std::string nameOf(const PictureKernel& kernel)
{
  std::string name;
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    if (kernel.Chosen & feature.Bit)
    {
      name += (name.empty() ? "" : "_") + std::string(feature.Name);
    }
  }
  return name.empty() ? "None" : name;
}

bool isComposite(const PictureKernel& kernel)
{
  return !isOf(kernel, "EXTREME") && !isOf(kernel, "SUM") && !isOf(kernel, "ISOSURFACES");
}

std::vector<Field> fieldsOf(const PictureKernel& kernel)
{
  const int count = isOf(kernel, "INDEPENDENT")         ? 3
                    : isOf(kernel, "COLOR_AND_OPACITY") ? 2
                    : isOf(kernel, "DIRECT_COLOR")      ? 4
                                                        : 1;
  return wavyFields(count);
}

// Scenes as they are without any of the features: constant cells at the level Fast.
struct MeshScene : Scene
{
  explicit MeshScene(const PictureKernel& kernel)
    : Scene(withComponents(jitteredLattice(4, 0.15, 1, sineField()), fieldsOf(kernel), VTK_DOUBLE),
        Width, Height)
  {
    this->Mapper->SetScalarModeToUseCellData();
    this->camera()->Zoom(2.0);
  }
  void drawPoints() { this->Mapper->SetScalarModeToUsePointData(); }
  void drawIndependent() { this->Mapper->SetVectorModeToAllComponents(); }
  void drawJumps() { this->Data->ShallowCopy(withJumps(this->Data, 0.3)); }
};

struct LatticeScene : StructuredScene
{
  explicit LatticeScene(const PictureKernel& kernel)
    : StructuredScene(rectilinearOf(sineField(), unevenCube(5)), Width, Height)
  {
    setComponents(this->Data, fieldsOf(kernel), VTK_DOUBLE);
    this->property()->SetInterpolationTypeToNearest();
    this->Mapper->InteractiveAdjustSampleDistancesOff();
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(0.07f);
    this->camera()->Zoom(2.0);
  }
  void drawPoints() { this->property()->SetInterpolationTypeToLinear(); }
  void drawIndependent() { this->property()->IndependentComponentsOn(); }
  void drawJumps() {}
};

// How a scene gets each feature by which kernels are chosen.
template <typename AnyScene>
struct Way
{
  const char* Feature;
  void (*Take)(AnyScene& scene);
};

template <typename AnyScene>
std::vector<Way<AnyScene>> ways()
{
  return {
    { "POINT_SCALARS", [](AnyScene& scene) { scene.drawPoints(); } },
    { "ADAPTIVE", [](AnyScene& scene) { scene.Mapper->SetAccuracyLevelToDefault(); } },
    { "EXTREME", [](AnyScene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); } },
    { "SUM", [](AnyScene& scene) { scene.Mapper->SetBlendModeToAdditive(); } },
    { "ISOSURFACES",
      [](AnyScene& scene)
      {
        scene.Mapper->SetBlendModeToIsoSurface();
        scene.property()->GetIsoSurfaceValues()->SetValue(0, 0.35);
        scene.property()->GetIsoSurfaceValues()->SetValue(1, 0.53);
      } },
    { "INDEPENDENT", [](AnyScene& scene) { scene.drawIndependent(); } },
    { "COLOR_AND_OPACITY", [](AnyScene& scene) { scene.property()->IndependentComponentsOff(); } },
    { "DIRECT_COLOR", [](AnyScene& scene) { scene.property()->IndependentComponentsOff(); } },
    { "CELL_GRADIENTS", [](AnyScene& scene) { scene.Mapper->SetGradientTypeToCell(); } },
    { "SHADING",
      [](AnyScene& scene)
      {
        setShading(scene.property());
        for (int k = 1; k < 4; ++k) // as the first component: others are left to VTK's mapper
        {
          vtkVolumeProperty* property = scene.property();
          property->SetShade(k, property->GetShade());
          property->SetAmbient(k, property->GetAmbient());
          property->SetDiffuse(k, property->GetDiffuse());
          property->SetSpecular(k, property->GetSpecular());
          property->SetSpecularPower(k, property->GetSpecularPower());
        }
        addLight(scene.Renderer, 3.0, 4.0, 1.5);
      } },
    { "STRUCTURED", [](AnyScene&) {} },
    { "CORNER_SCALARS", [](AnyScene& scene) { scene.drawJumps(); } },
    { "POINT_SAMPLED", [](AnyScene& scene) { scene.Mapper->SetAccuracyLevelToSampled(); } },
  };
}

template <typename AnyScene>
void take(AnyScene& scene, const PictureKernel& kernel)
{
  scene.Mapper->SetAccuracyLevelToFast();
  const int components = static_cast<int>(fieldsOf(kernel).size());
  if (components > 1)
  {
    setComponentFunctions(scene.property(), components);
  }
  std::uint64_t taken = 0;
  for (const Way<AnyScene>& way : ways<AnyScene>())
  {
    for (const VariantKey::Feature& feature : VariantKey::features())
    {
      if (feature.Name == std::string(way.Feature) && (kernel.Chosen & feature.Bit) != 0)
      {
        way.Take(scene);
        taken |= feature.Bit;
      }
    }
  }
  EXPECT_EQ(taken, kernel.Chosen) << "no scene has some of the features";
}

// Cuts, holes, opaque geometry, and light through the volume: what every kernel knows beside the
// features of its key.
template <typename AnyScene>
void takeWhatAllKnow(AnyScene& scene, const PictureKernel& kernel)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.45, 0.7);
  plane->SetNormal(-0.6, 0.3, -1.0);
  scene.Mapper->AddClippingPlane(plane);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.237, 0.711, 0.313, 0.564, 0.159, 0.823);
  scene.Mapper->SetCroppingRegionFlagsToInvertedCross();
  markCells(
    scene.Data, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType id) { return id % 11 == 3; });
  for (vtkDataSetAttributes* data :
    { static_cast<vtkDataSetAttributes*>(scene.Data->GetPointData()),
      static_cast<vtkDataSetAttributes*>(scene.Data->GetCellData()) })
  {
    vtkDataArray* scalars = data->GetScalars();
    for (vtkIdType i = 5; i < scalars->GetNumberOfTuples(); i += 37)
    {
      scalars->SetComponent(i, i % 2 ? 0 : scalars->GetNumberOfComponents() - 1, std::nan(""));
    }
  }
  scene.Mapper->DrawNanCellsOn();
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
  scene.Renderer->AddActor(makeBall({ 0.2, 0.25, 0.2 }, 0.3, { 1.0, 1.0, 1.0 }));
  if (isOf(kernel, "SHADING") && isComposite(kernel) && !isOf(kernel, "INDEPENDENT"))
  {
    setGradientOpacity(scene.property());
    scene.Mapper->SetShadowMethodToAtVertices();
    scene.Mapper->AmbientOcclusionOn();
    scene.Mapper->SetVolumetricScatteringBlending(0.7f);
  }
}

// By the kernel of the picture's key, at the accuracy of the frame.
template <typename AnyScene>
Image traced(AnyScene& scene, int arithmetic)
{
  Image picture(Width, Height);
  vtkNew<vtkTable> cells;
  for (int i = 0; i < Width * Height; ++i)
  {
    const int x = i % Width;
    const int y = i / Width;
    EXPECT_TRUE(scene.Mapper->TraceRay(scene.Volume, x, y, arithmetic, cells));
    EXPECT_GT(cells->GetNumberOfRows(), 0) << "the ray of pixel " << x << ", " << y << " misses";
    vtkDataArray* color = cells->GetFieldData()->GetArray("Color");
    for (int k = 0; k < 4; ++k)
    {
      picture.pixel(x, y)[k] = static_cast<float>(color->GetComponent(0, k));
    }
  }
  return picture;
}

// Of the shaders that the window has compiled.
std::string shadersOf(vtkRenderWindow* window)
{
  window->MakeCurrent();
  std::string texts;
  for (GLuint name = 1; name < LeastNames; ++name)
  {
    GLint length = 0;
    if (glIsShader(name))
    {
      glGetShaderiv(name, GL_SHADER_SOURCE_LENGTH, &length);
    }
    if (length > 0)
    {
      std::string text(static_cast<std::size_t>(length), ' ');
      glGetShaderSource(name, length, nullptr, text.data());
      texts += text;
    }
  }
  return texts;
}

template <typename AnyScene>
Image expectParity(AnyScene& scene, int arithmetic)
{
  const Image drawn = scene.render();
  const Image marched = traced(scene, arithmetic);
  const Difference difference = compare(drawn, marched, {}, MostError);
  EXPECT_LE(difference.Max, MostError) << difference.text();
  EXPECT_GT(compare(marched, Image(Width, Height)).Max, 0.05) << "nothing is seen";
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  return drawn;
}

// Returns the texts of the shaders.
template <typename AnyScene>
std::string draw(const PictureKernel& kernel)
{
  AnyScene scene(kernel);
  take(scene, kernel);
  const Image plain = expectParity(scene, Mapper::TRACE_FLOAT);
  const std::string shaders = shadersOf(scene.Window);
  keepScenePage(scene.Window);
  takeWhatAllKnow(scene, kernel);
  EXPECT_GT(compare(expectParity(scene, Mapper::TRACE_DOUBLE), plain).Max, 0.1) << "nothing is cut";
  keepScenePage(scene.Window);
  return shaders;
}

TEST(KernelParity, OfEachKernel)
{
  std::set<std::string> shaders;
  for (const PictureKernel& kernel : tetmarch::pictureKernels())
  {
    std::cout << nameOf(kernel) << '\n';
    SCOPED_TRACE(nameOf(kernel));
    EXPECT_TRUE(
      shaders
        .insert(isOf(kernel, "STRUCTURED") ? draw<LatticeScene>(kernel) : draw<MeshScene>(kernel))
        .second)
      << "the scene has the shaders of another kernel";
  }
}
} // namespace
