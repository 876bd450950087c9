// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth of lit pictures, which has the light of every point, against brute force.
#include "Reference/LightRayPointKernel.h"

#include "LatticeTruth.h"
#include "LightTruth.h"
#include "StagedFrame.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Point = tetmarch::testing::Vec3;

// Lights without surfaces, and the brightness that they give a point.
class LitPicture : public StagedScene
{
public:
  static constexpr int Size = Shot::Size / 3; // so that its pixels are some of a shot's

  LitPicture(const Field& field, bool isImage, bool ofCells, int cells)
    : StagedScene(isImage ? vtkSmartPointer<vtkDataSet>(imageOf(field, unitCube(cells)))
                          : vtkSmartPointer<vtkDataSet>(jitteredLattice(cells, 0.15, 1, field)))
    , IsImage(isImage)
    , OfCells(ofCells)
  {
    this->draw(this->Data, ofCells);
    this->Input.Drawn.Volume.Between = ofCells ? Interpolation::Nearest : Interpolation::Linear;
    this->Input.Effects.Shadows = ShadowMethod::AtVertices;
    this->Input.Effects.Scattering = 2;
    this->property()->ShadeOn();
    this->property()->SetAmbient(0);
    this->property()->SetDiffuse(1);
    this->property()->SetSpecular(0);
    this->property()->SetScalarOpacityUnitDistance(0.2);
  }

  // (x, y, z) is the direction to the light, 0; or its position, 1.
  vtkSmartPointer<vtkLight> addLight(const LightPlace& place, double intensity)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetPosition(place.data());
    light->SetPositional(place[3] > 0.0);
    light->SetConeAngle(180);
    light->SetIntensity(intensity);
    this->Renderer->AddLight(light);
    this->Brightness.push_back([place, intensity](const LightTruth& truth, const Point& point)
      { return intensity * truth.transmittance(point, place); });
    return light;
  }
  void addHeadlight()
  {
    double eye[3];
    this->Renderer->GetActiveCamera()->GetPosition(eye);
    const auto light = this->addLight({ eye[0], eye[1], eye[2], 1 }, 1);
    light->SetLightTypeToHeadlight();
    light->PositionalOff();
  }

  // Light from around alone.
  void occlude()
  {
    this->addLight({ 0, 0, 1, 0 }, 1);
    this->property()->SetAmbient(1);
    this->property()->SetDiffuse(0);
    this->Input.Effects.Occlusion = true;
    this->Input.Effects.OcclusionDirections = 3;
    const double radius = this->Input.Effects.OcclusionRadius * std::sqrt(3.0);
    const int count = this->Input.Effects.OcclusionDirections;
    this->Brightness = { [radius, count](const LightTruth& truth, const Point& point)
      {
        LightRayPointKernel<double> kernel;
        double sum = 0.0;
        for (int k = 0; k < count; ++k)
        {
          const auto way = kernel.sphereDirection(k, count);
          sum += truth.transmittance(point, { way.x, way.y, way.z, 0 }, radius) / count;
        }
        return sum;
      } };
  }
  void shineOverPlate();
  void shineOnSurfaces(const Point& light);

  // The greatest difference of a channel.
  double error() const
  {
    const OpticalModel model{ this->Volume->GetProperty()->GetRGBTransferFunction(),
      this->Volume->GetProperty()->GetScalarOpacity(), nullptr,
      this->Volume->GetProperty()->GetScalarOpacityUnitDistance() };
    if (this->IsImage)
    {
      const LatticeTruth scene(this->Data, model,
        this->OfCells ? LatticeValues::CellsNearest : LatticeValues::PointsLinear);
      return this->errorTo(LightTruth(scene));
    }
    const GroundTruthScene scene(vtkUnstructuredGrid::SafeDownCast(this->Data), model,
      this->OfCells ? ScalarsOf::Cells : ScalarsOf::Points);
    return this->errorTo(LightTruth(scene));
  }

  std::vector<std::function<double(const LightTruth&, const Point&)>> Brightness;

private:
  double errorTo(const LightTruth& truth) const
  {
    const FreshFrame frame(this->Input);
    const ReferenceImage image = frame.at(GroundTruthAccuracy, Size, Size)->render<double>();
    const auto brightness = [&](const Point& point)
    {
      double sum = 0.0;
      for (const auto& light : this->Brightness)
      {
        sum += light(truth, point);
      }
      return sum;
    };
    const Shot shot;
    double most = 0.0;
    double seenMost = 0.0;
    for (int i = 0; i < Size * Size; ++i)
    {
      const auto [from, to] = lineOf(shot, i % Size * 3 + 1, i / Size * 3 + 1);
      const auto seen =
        truth.seen(from, { to[0] - from[0], to[1] - from[1], to[2] - from[2] }, brightness, 1e-6);
      for (int k = 0; k < 4; ++k)
      {
        most = std::max(most, std::abs(seen[k] - double(image.Pixels[4 * i + k])));
        seenMost = std::max(seenMost, seen[k]);
      }
    }
    EXPECT_GT(seenMost, 0.2) << "hardly anything is seen";
    return most;
  }

  bool IsImage;
  bool OfCells;
};

struct LitCase
{
  const char* Name;
  Field Of;
  std::vector<std::array<double, 2>> Opacities;
  double UnitDistance;
  std::function<void(LitPicture&)> Light;
  bool OfEachKind = true; // else an image of points
};

// A line towards a light of castShadow() meets the plate.
bool isBehindPlate(const Point& p)
{
  const Point corner{ 0.83, 1.16, 0.07 };
  const Point sides[2] = { { 0.88, -0.49, 0.0 }, { 0.0, 0.0, 1.02 } };
  const Point way{ 3.0, 4.0, 1.0 };
  // In the plane z = 0 the plate is a line.
  const double scale = way[0] * sides[0][1] - way[1] * sides[0][0];
  const double t = ((corner[0] - p[0]) * sides[0][1] - (corner[1] - p[1]) * sides[0][0]) / scale;
  const double along = (p[0] + t * way[0] - corner[0]) / sides[0][0];
  const double up = (p[2] + t * way[2] - corner[2]) / sides[1][2];
  return t > 0.0 && along > 0.0 && along < 1.0 && up > 0.0 && up < 1.0;
}

// From the middle of the unit cube; linear gradients, which central differences find.
double squaredDistance(double x, double y, double z)
{
  return (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) + (z - 0.5) * (z - 0.5);
}

// The cosine between the surface of that distance and a light at infinity.
double facing(const Point& p, const Point& light)
{
  const double r = std::sqrt(squaredDistance(p[0], p[1], p[2]));
  double turned = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    turned += (p[a] - 0.5) * light[a];
  }
  return r > 0.0 ? std::abs(turned) / r : 0.0;
}

void LitPicture::shineOverPlate()
{
  const double far = std::sqrt(26.0);
  this->addLight({ 3.0 / far, 4.0 / far, 1.0 / far, 0 }, 1);
  this->addPlate();
  const auto unshadowed = this->Brightness.front();
  this->Brightness = { [unshadowed](const LightTruth& truth, const Point& point)
    { return isBehindPlate(point) ? 0.0 : unshadowed(truth, point); } };
}

void LitPicture::shineOnSurfaces(const Point& light)
{
  this->addLight({ light[0], light[1], light[2], 0 }, 1);
  this->Input.Effects.Scattering = 0;
  const auto everywhere = this->Brightness.front();
  this->Brightness = { [everywhere, light](const LightTruth& truth, const Point& point)
    { return facing(point, light) * everywhere(truth, point); } };
}

const std::vector<std::array<double, 2>> Soft = { { 0.0, 0.0 }, { 0.5, 0.3 }, { 1.0, 0.9 } };
const std::vector<std::array<double, 2>> ThinAndThick = { { 0.0, 0.1 }, { 1.0, 1.0 } };
const std::vector<std::array<double, 2>> Peak = { { 0.0, 0.02 }, { 0.49, 0.02 }, { 0.5, 1.0 },
  { 0.51, 0.02 }, { 1.0, 0.02 } };
const std::vector<std::array<double, 2>> Ball = { { 0.0, 0.8 }, { 0.08, 0.8 }, { 0.12, 0.0 },
  { 1.0, 0.0 } };

const std::vector<LitCase> Cases = {
  { "two lights", sineField(), Soft, 0.2,
    [](LitPicture& picture)
    {
      picture.addLight({ 0.48, 0.6, 0.64, 0 }, 0.6);
      picture.addLight({ 1.4, 0.8, 0.3, 1 }, 0.4);
    } },
  // Two sides of the cube are in the plane of the light.
  { "a slab shadows a slab", [](double, double, double z) { return z > 0.5 ? 1.0 : 0.0; },
    ThinAndThick, 0.1,
    [](LitPicture& picture) {
      picture.addLight({ 0.6, 0.0, 0.8, 0 }, 1);
    } },
  { "a ball in fog",
    [](double x, double y, double z) { return squaredDistance(x, y, z) < 0.09 ? 1.0 : 0.0; },
    ThinAndThick, 0.1,
    [](LitPicture& picture) {
      picture.addLight({ 0.9, 0.85, 0.8, 1 }, 1);
    } },
  // With depths up to 100 in cells that have one value.
  { "a sheet thinner than a cell",
    [](double x, double y, double z) { return (x + 2.0 * y + z) / 4.0; }, Peak, 0.01,
    [](LitPicture& picture) {
      picture.addLight({ 0.0, 0.8, 0.6, 0 }, 1);
    } },
  { "headlight", sineField(), Soft, 0.2, [](LitPicture& picture) { picture.addHeadlight(); } },
  { "occlusion", sineField(), Soft, 0.1, [](LitPicture& picture) { picture.occlude(); } },
  { "a plate", sineField(), Soft, 0.5, [](LitPicture& picture) { picture.shineOverPlate(); } },
  { "surfaces", squaredDistance, Ball, 0.3,
    [](LitPicture& picture) {
      picture.shineOnSurfaces({ 0.48, 0.6, 0.64 });
    },
    false },
};

// LightTolerance allows 0.06/255 of this.
constexpr double Tolerance = 0.1 / 255.0;

TEST(LitGroundTruth, IsBruteForce)
{
  for (const LitCase& lit : Cases)
  {
    for (const bool isImage : { true, false })
    {
      for (const bool ofCells : { false, true })
      {
        if (!lit.OfEachKind && (!isImage || ofCells))
        {
          continue;
        }
        LitPicture picture(lit.Of, isImage, ofCells, lit.OfEachKind ? (isImage ? 4 : 3) : 8);
        picture.show(lit.Opacities);
        picture.property()->SetScalarOpacityUnitDistance(lit.UnitDistance);
        lit.Light(picture);
        const double error = picture.error();
        std::cout << "[ MEASURED ] " << lit.Name << (isImage ? ", image" : ", mesh")
                  << (ofCells ? " of cells" : " of points") << ": off by at most " << 255 * error
                  << "/255\n";
        EXPECT_LE(error, Tolerance) << lit.Name;
      }
    }
  }
}
} // namespace
