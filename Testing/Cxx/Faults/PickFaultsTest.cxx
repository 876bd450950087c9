// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses of picks and selections.
#include "FaultScene.h"
#include "PickScene.h"

#include <cmath>
#include <functional>
#include <set>
#include <string>

namespace
{
using namespace tetmarch::testing;

class PickFaults : public FaultScene<PickScene>
{
protected:
  static constexpr int Middle = Side / 2;

  PickFaults()
  {
    this->Shown.property()->SetScalarOpacityUnitDistance(0.1);
    this->lookOnce();
    this->All = this->cells();
    EXPECT_GT(this->All.size(), 50u);
    EXPECT_TRUE(this->pick());
    this->Hit = this->Mapper->GetPickedCellId();
  }

  // The cells of the volume that are selected in all of the window.
  std::set<vtkIdType> cells() { return this->Shown.selectAll()[this->Shown.Volume]; }
  bool pick()
  {
    return this->Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, Middle, Middle);
  }

  std::set<vtkIdType> All;
  vtkIdType Hit = -1;
};

TEST_F(PickFaults, EveryCallOfASelection)
{
  for (const Fault fault : AllFaults)
  {
    const bool ofShaders = fault == Fault::CompileStatus || fault == Fault::LinkStatus;
    this->release(ofShaders);
    const auto objects = countGLObjects();
    int calls = 0;
    int errors = 0;
    for (; calls < 100; ++calls)
    {
      SCOPED_TRACE(std::string(nameOf(fault)) + ", call " + std::to_string(calls));
      this->Watch.Errors.clear();
      std::set<vtkIdType> found;
      const bool met = this->meetIn([&] { found = this->cells(); }, fault, calls);
      if (!met || this->Watch.Errors.empty())
      {
        EXPECT_EQ(found, this->All);
      }
      if (!met)
      {
        break;
      }
      errors += this->Watch.Errors.empty() ? 0 : 1;
      EXPECT_EQ(this->cells(), this->All);
      this->release(ofShaders);
      EXPECT_EQ(countGLObjects(), objects);
    }
    EXPECT_GT(errors, 0) << nameOf(fault);
    std::cout << "[ MEASURED ] " << nameOf(fault) << ": " << calls << " calls, " << errors
              << " of them are reported\n";
  }
  this->expectSound(this->frame());
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
}

// A pick is right, or there is none: a selector draws several passes, each of which may fail.
TEST_F(PickFaults, EveryCallOfAPick)
{
  for (const Fault fault : AllFaults)
  {
    const bool ofShaders = fault == Fault::CompileStatus || fault == Fault::LinkStatus;
    for (int calls = 0; calls < 100; ++calls)
    {
      SCOPED_TRACE(std::string(nameOf(fault)) + ", call " + std::to_string(calls));
      this->release(ofShaders);
      this->Watch.Errors.clear();
      bool hit = false;
      const bool met = this->meetIn([&] { hit = this->pick(); }, fault, calls);
      EXPECT_EQ(hit, this->Watch.Errors.empty());
      EXPECT_EQ(this->Mapper->GetPickedCellId(), hit ? this->Hit : -1);
      EXPECT_EQ(std::isnan(this->Mapper->GetPickedScalar()), !hit);
      EXPECT_TRUE(this->pick());
      EXPECT_EQ(this->Mapper->GetPickedCellId(), this->Hit);
      if (!met)
      {
        break;
      }
    }
  }
}

// The fault is in one of the selector's passes alone. One of them marches; the others draw what it
// has found, without a framebuffer of their own.
TEST_F(PickFaults, InOnePassOfAPick)
{
  int failed = 0;
  for (int pass = 0; pass < 6; ++pass)
  {
    SCOPED_TRACE(pass);
    this->Watch.Errors.clear();
    int passes = 0;
    bool met = false;
    this->Mapper->Around = [&](const std::function<void()>& draw)
    {
      const FaultyGL faulty(Fault::FramebufferStatus, passes++ == pass ? 0 : 1000);
      draw();
      met = met || faulty.happened();
    };
    const bool hit = this->pick();
    this->Mapper->Around = nullptr;
    EXPECT_EQ(hit, !met);
    EXPECT_EQ(this->Watch.Errors.size(), met ? 1u : 0u);
    EXPECT_EQ(this->Mapper->GetPickedCellId(), hit ? this->Hit : -1);
    failed += met ? 1 : 0;
  }
  EXPECT_EQ(failed, 1);
}

TEST_F(PickFaults, AreReportedOnce)
{
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(this->meetIn([this] { EXPECT_FALSE(this->pick()); }, Fault::TexImage, 0));
  }
  ASSERT_GE(this->Watch.Errors.size(), 1u);
  for (const std::string& error : this->Watch.Errors)
  {
    EXPECT_NE(error.find("The GPU has no room for"), std::string::npos) << error;
  }
  EXPECT_TRUE(this->pick());
  this->expectSound(this->frame());
}
} // namespace
