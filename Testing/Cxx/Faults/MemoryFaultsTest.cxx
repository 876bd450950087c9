// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory ends at any allocation of a first frame: one error, nothing drawn in part, nothing left on
// the GPU, and the next frame is right.
#include "ErrorWatch.h"
#include "GLObjects.h"
#include "ScarceMemory.h"
#include "Scene.h"
#include "SmartScene.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 32;

// A back end of VTK's loops, and what is tried with it.
struct BackEnd
{
  const char* Name;
  std::size_t Bytes; // of the smallest allocation that fails
  int Frames;        // of a scene; all allocations if they are fewer
};
// Where there is no memory for the job that it gives a thread, STDThread ends the process.
constexpr BackEnd BackEnds[] = { { "Sequential", 0, 500 }, { "STDThread", 128, 60 },
  { "TBB", 128, 60 } };

// An address in the library whose allocations fail.
const void* ourLibrary() { return reinterpret_cast<const void*>(&vtkTetMarchSettings::New); }

template <typename SceneType>
class MemoryEnds
{
public:
  using Mapper = std::remove_pointer_t<decltype(SceneType::Mapper.Get())>;

  MemoryEnds(const char* name, SceneType& scene, const std::function<void(Mapper*)>& setUp)
    : Name(name)
    , Shown(scene)
    , SetUp(setUp)
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Shown.Volume->VisibilityOff();
    this->Empty = this->frame();
    this->Shown.Volume->VisibilityOn();
  }

  void expectOneErrorEach(const BackEnd& backEnd)
  {
    this->LeastBytes = backEnd.Bytes;
    const int tries = this->drawAnew(-2, true); // none fails
    ASSERT_GT(tries, 50) << this->Name;
    const auto objects = countGLObjects();
    const int step = std::max(1, tries / backEnd.Frames);
    int failures = 0;
    int errors = 0;
    for (int k = 0; k < tries; k += step)
    {
      SCOPED_TRACE(std::string(this->Name) + ", allocation " + std::to_string(k));
      errors += this->drawAnew(k, false);
      failures += ScarceMemory::failures();
      if (::testing::Test::HasFailure())
      {
        return;
      }
    }
    EXPECT_EQ(countGLObjects(), objects) << this->Name;
    EXPECT_GT(errors, failures / 2) << this->Name;
    std::cout << "[ MEASURED ] " << this->Name << ": " << tries << " allocations, " << failures
              << " failed, " << errors << " of them end the frame\n";
  }

private:
  Image frame()
  {
    this->Shown.Window->Render();
    return framePictureOf(this->Shown.Window);
  }

  // A new mapper's first frame, in which the allocation with that number fails, and its second one.
  // Returns how many allocations the first one makes, or how many errors it has.
  int drawAnew(int allocation, bool isSound)
  {
    vtkNew<Mapper> mapper;
    this->SetUp(mapper);
    mapper->SetInputDataObject(this->Shown.Data);
    this->Shown.Volume->SetMapper(mapper);
    const ErrorWatch watch(mapper);
    Image first;
    int tries = 0;
    {
      const ScarceMemory scarce(this->LeastBytes, allocation, ourLibrary());
      EXPECT_NO_THROW(this->Shown.Window->Render());
      tries = ScarceMemory::tries();
    }
    first = framePictureOf(this->Shown.Window);
    this->Sound = isSound ? first : this->Sound;
    const std::size_t errors = watch.Errors.size();
    EXPECT_LE(errors, isSound ? 0u : 1u);
    const bool isWhole = errors == 0 || watch.Errors[0].find("is complete") != std::string::npos;
    EXPECT_EQ(compare(first, isWhole ? this->Sound : this->Empty).Max, 0);
    EXPECT_TRUE(errors == 0 || watch.Errors[0].find("too little memory") != std::string::npos)
      << watch.Errors[0];
    mapper->GetInputDataObject(0, 0)->Modified();
    EXPECT_EQ(compare(this->frame(), this->Sound).Max, 0);
    EXPECT_EQ(watch.Errors.size(), errors);
    this->Shown.Volume->SetMapper(this->Shown.Mapper);
    return isSound ? tries : static_cast<int>(errors);
  }

  const char* Name;
  SceneType& Shown;
  std::function<void(Mapper*)> SetUp;
  std::size_t LeastBytes = 0;
  Image Empty;
  Image Sound;
};

// What VTK's back ends make of an exception in a thread, and in which order allocations come,
// differs.
class MemoryFaults : public ::testing::TestWithParam<BackEnd>
{
protected:
  static void run(const std::function<void()>& work)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, GetParam().Name, false }, [&work] { work(); });
  }
};

TEST_P(MemoryFaults, MeshWithLight)
{
  Scene scene(latticeWithHole(4, 0.15, 1, sineField()), Side, Side);
  setShading(scene.property());
  setGradientOpacity(scene.property());
  MemoryEnds<Scene> ends("mesh", scene,
    [](vtkTetMarchVolumeMapper* mapper)
    {
      mapper->GetSettings()->SetAmbientOcclusion(true);
      mapper->CollectDiagnosticsOn();
    });
  run([&] { ends.expectOneErrorEach(GetParam()); });
}

TEST_P(MemoryFaults, Image)
{
  SmartScene scene(imageOf(sineField()), Side, Side);
  setShading(scene.property());
  MemoryEnds<SmartScene> ends("image", scene, [](vtkTetMarchSmartVolumeMapper*) {});
  run([&] { ends.expectOneErrorEach(GetParam()); });
}

INSTANTIATE_TEST_SUITE_P(With, MemoryFaults, ::testing::ValuesIn(BackEnds),
  [](const auto& backEnd) { return std::string(backEnd.param.Name); });
} // namespace
