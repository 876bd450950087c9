// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes and cropping in the frame of the mesh: where they are in the world and in the
// data, and what can't be used.
#include "View/Clipping.h"

#include "CutLine.h"
#include "RandomRays.h"
#include "UnitMeshes.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkTransform.h"
#include "vtkVolume.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// A mesh of unit cubes, somewhere, and a volume that is stretched and turned.
class ClippingOf : public ::testing::Test
{
protected:
  ClippingOf()
  {
    this->Options.Planes = this->Planes;
    vtkNew<vtkTransform> transform;
    transform->Translate(0.3, 0.4, -20.0);
    transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
    transform->Scale(0.5, 1.4, -0.8);
    transform->RotateZ(25.0);
    this->Volume->SetUserTransform(transform);
  }

  void moveTo(double offset)
  {
    this->Mesh = built(
      withOffsetAndScale(jitteredLattice(3, 0.15), { offset, -2.0 * offset, 3.0 * offset }, 1.0));
  }

  void addPlane(const Vec3& origin, const Vec3& normal)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin[0], origin[1], origin[2]);
    plane->SetNormal(normal[0], normal[1], normal[2]);
    this->Planes->AddItem(plane);
  }

  std::string make()
  {
    return makeClipping(this->Options, this->Volume, this->Mesh.Frame, this->Made);
  }

  // The world's coordinates of a point of the frame.
  std::array<long double, 3> worldOf(const Vec3& p)
  {
    std::array<long double, 3> world{};
    for (int r = 0; r < 3; ++r)
    {
      world[r] = this->Volume->GetMatrix()->GetElement(r, 3);
      for (int k = 0; k < 3; ++k)
      {
        const auto data = static_cast<long double>(this->Mesh.Frame.Center[k]) +
                          this->Mesh.Frame.Radius * (long double)(p[k]);
        world[r] += this->Volume->GetMatrix()->GetElement(r, k) * data;
      }
    }
    return world;
  }

  Vec3 randomPoint() { return { this->next(), this->next(), this->next() }; }
  double next() { return this->Random.uniformBetween(-1.0, 1.0); }

  RandomRays Random{ 5 };
  TetMesh Mesh = built(jitteredLattice(3, 0.15));
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkPlaneCollection> Planes;
  ClippingOptions Options;
  Clipping Made;
};

// Distances from the plane, however far from the origin the mesh lies.
TEST_F(ClippingOf, PlanesAreWhereTheyAreInTheWorld)
{
  for (const double offset : { 0.0, 1e3, 1e6 })
  {
    this->moveTo(offset);
    for (int i = 0; i < 200; ++i)
    {
      this->Planes->RemoveAllItems();
      const Vec3 on = this->randomPoint();
      const auto origin = this->worldOf(on);
      const Vec3 at{ double(origin[0]), double(origin[1]), double(origin[2]) };
      const Vec3 normal = this->randomPoint();
      this->addPlane(at, normal);
      ASSERT_EQ(this->make(), "");
      ASSERT_EQ(this->Made.Planes.size(), 1u);
      const auto& plane = this->Made.Planes[0];
      EXPECT_NEAR(std::hypot(plane[0], plane[1], plane[2]), 1.0, 1e-15);
      const auto heightOf = [&](const Vec3& p)
      {
        const auto world = this->worldOf(p);
        long double height = 0.0L;
        for (int k = 0; k < 3; ++k)
        {
          height += normal[k] * (world[k] - at[k]);
        }
        return height;
      };
      // The plane's height grows in the frame by that per unit along its normal.
      const auto slope =
        heightOf({ on[0] + plane[0], on[1] + plane[1], on[2] + plane[2] }) - heightOf(on);
      EXPECT_GT(slope, 0.0L);
      for (int k = 0; k < 5; ++k)
      {
        const Vec3 p = this->randomPoint();
        const double height = plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
        EXPECT_NEAR(height, double(heightOf(p) / slope), 1e-15 * (8.0 + 30.0 * offset));
      }
    }
  }
}

TEST_F(ClippingOf, PlanesFarAwayCutAllOrNothing)
{
  for (const double far : { 1e3, 1e30, 1e300 })
  {
    this->Planes->RemoveAllItems();
    this->addPlane({ far, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
    this->addPlane({ far, 0.0, 0.0 }, { -1e-300, 0.0, 0.0 });
    ASSERT_EQ(this->make(), "");
    EXPECT_EQ(this->Made.Planes[0][3], -Clipping::Farthest);
    EXPECT_EQ(this->Made.Planes[1][3], Clipping::Farthest);
    EXPECT_TRUE(this->Made.cuts());
  }
}

TEST_F(ClippingOf, NothingIsNothing)
{
  EXPECT_EQ(this->make(), "");
  EXPECT_FALSE(this->Made.cuts() || this->Made.LeavesNothing);
  this->Options.Planes = nullptr;
  EXPECT_EQ(this->make(), "");
  EXPECT_FALSE(this->Made.cuts());
  this->Options.CroppingFlags = 0; // but cropping is off
  EXPECT_EQ(this->make(), "");
  EXPECT_FALSE(this->Made.cuts() || this->Made.LeavesNothing);
}

TEST_F(ClippingOf, RefusesPlanesThatAreNone)
{
  const Vec3 zero{ 0.0, 0.0, 0.0 };
  for (const auto& [origin, normal] : { std::pair<Vec3, Vec3>{ zero, zero },
         { zero, { NaN, 0.0, 1.0 } }, { zero, { Infinity, 0.0, 1.0 } },
         { { NaN, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } }, { { 0.0, Infinity, 0.0 }, { 0.0, 1.0, 0.0 } } })
  {
    this->Planes->RemoveAllItems();
    this->addPlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    this->addPlane(origin, normal);
    EXPECT_NE(this->make().find("Clipping plane 1 "), std::string::npos) << this->make();
  }
}

TEST_F(ClippingOf, TakesManyPlanesAndRefusesMore)
{
  for (int i = 0; i < Clipping::MostUserPlanes; ++i)
  {
    this->addPlane({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, double(i) });
  }
  this->Options.Cropping = true;
  this->Options.CroppingPlanes = { { 0.2, 0.7, 0.2, 0.7, 0.2, 0.7 } };
  this->Options.CroppingFlags = 0x0002000;
  EXPECT_EQ(this->make(), "");
  EXPECT_EQ(this->Made.Planes.size(), std::size_t(Clipping::MostPlanes));
  this->addPlane({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  EXPECT_NE(this->make().find("33 clipping planes"), std::string::npos) << this->make();
}

// Whether by planes or by regions.
bool isLeftBy(const Clipping& clipping, const Vec3& p)
{
  bool left = true;
  for (const auto& plane : clipping.Planes)
  {
    left = left && plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] >= 0.0;
  }
  int region = 0;
  for (int k = 0, factor = 1; k < 3; ++k, factor *= 3)
  {
    region += factor * ((p[k] >= clipping.CroppingLow[k]) + (p[k] >= clipping.CroppingHigh[k]));
  }
  return left && (clipping.CroppingFlags >> region & 1) != 0;
}

TEST_F(ClippingOf, CroppingLeavesItsRegions)
{
  this->moveTo(1e6);
  const Vec3& c = this->Mesh.Frame.Center;
  this->Options.Cropping = true;
  this->Options.CroppingPlanes = { { c[0] - 0.2, c[0] + 0.1, c[1] - 0.3, c[1] + 0.2, c[2],
    c[2] + 0.3 } };
  std::vector<int> flags = croppingFlagsToTest();
  for (int i = 0; i < 200; ++i)
  {
    flags.push_back(static_cast<int>((this->next() + 1.0) * 0x3ffffff) + 1);
  }
  for (const int f : flags)
  {
    this->Options.CroppingFlags = f;
    ASSERT_EQ(this->make(), "");
    EXPECT_FALSE(this->Made.LeavesNothing);
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 p = this->randomPoint();
      Vec3 data;
      for (int k = 0; k < 3; ++k)
      {
        data[k] = c[k] + p[k] * this->Mesh.Frame.Radius;
      }
      ASSERT_EQ(isLeftBy(this->Made, p), !isCroppedAway(this->Options, data)) << std::hex << f;
    }
  }
}

// Regions that make a box are cut by planes alone, by no more of them than the box has faces.
TEST_F(ClippingOf, BoxesOfRegionsAreHalfSpaces)
{
  this->Options.Cropping = true;
  this->Options.CroppingPlanes = { { 0.2, 0.7, 0.2, 0.7, 0.2, 0.7 } };
  const auto planesOf = [this](int flags)
  {
    this->Options.CroppingFlags = flags;
    EXPECT_EQ(this->make(), "");
    return this->Made.Cropped ? -1 : static_cast<int>(this->Made.Planes.size());
  };
  for (int region = 0; region < 27; ++region)
  {
    const int middles = (region % 3 == 1) + (region / 3 % 3 == 1) + (region / 9 == 1);
    EXPECT_EQ(planesOf(1 << region), 3 + middles) << region;
    EXPECT_EQ(planesOf(0x7ffffff & ~(1 << region)), -1) << region;
  }
  EXPECT_EQ(planesOf(0x00001ff), 1);  // the lowest layer
  EXPECT_EQ(planesOf(0x003ffff), 1);  // two of them
  EXPECT_EQ(planesOf(0x003fe00), 2);  // the one between
  EXPECT_EQ(planesOf(0x7fc01ff), -1); // the two others
  EXPECT_EQ(planesOf(0x0000003), 3);  // two of an edge
  EXPECT_EQ(planesOf(0x0000005), -1);
  EXPECT_EQ(planesOf(0x7ffffff), 0);
  EXPECT_FALSE(this->Made.cuts());
}

TEST_F(ClippingOf, CroppingThatLeavesNothing)
{
  this->Options.Cropping = true;
  const std::array<double, 6> good{ { 0.2, 0.7, 0.2, 0.7, 0.2, 0.7 } };
  for (const int flags : { 0x0002000, 0x2ebfeba, 0x7ffffff, 0 })
  {
    this->Options.CroppingFlags = flags;
    this->Options.CroppingPlanes = good;
    EXPECT_EQ(this->make(), "");
    EXPECT_EQ(this->Made.LeavesNothing, flags == 0);
    for (int i = 0; i < 6; ++i)
    {
      this->Options.CroppingPlanes = good;
      this->Options.CroppingPlanes[i] = i % 2 ? 0.2 : 0.7;
      EXPECT_EQ(this->make(), "");
      EXPECT_TRUE(this->Made.LeavesNothing);
      this->Options.CroppingPlanes[i] = NaN;
      EXPECT_NE(this->make().find("not a number"), std::string::npos);
    }
  }
}

TEST_F(ClippingOf, CroppingPlanesMayBeInfinite)
{
  this->Options.Cropping = true;
  this->Options.CroppingPlanes = { { -Infinity, Infinity, -1e300, 0.5, 0.4, Infinity } };
  this->Options.CroppingFlags = 0x0002000;
  EXPECT_EQ(this->make(), "");
  EXPECT_TRUE(isLeftBy(this->Made, { 0.9, -0.9, 0.9 }));
  EXPECT_FALSE(isLeftBy(this->Made, { 0.9, 0.1, 0.9 }));
  EXPECT_FALSE(isLeftBy(this->Made, { 0.9, -0.9, -0.9 }));
}
} // namespace
