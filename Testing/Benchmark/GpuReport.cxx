// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuReport.h"

#include "ChildProcess.h"
#include "Effects.h"
#include "Failure.h"
#include "Machine.h"
#include "OutputFile.h"
#include "WorkerAnswers.h"

#include "vtkVersion.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr int Format = 1;       // of the file: another one if keys are renamed
constexpr int MostPixels = 256; // along an edge of the pictures that the CPU computes, too
// The CPU computes with no regard to time, on however few cores.
constexpr double ParityLimitFactor = 10.0;

struct ParityScene
{
  std::string Dataset;
  std::string Effect;
};

/// Convex, with holes, a real mesh, and lit.
const std::array<ParityScene, 4>& parityScenes()
{
  static const std::array<ParityScene, 4> scenes = { { { "lattice:12", NoEffect },
    { "cheese:18", NoEffect }, { "golfball", NoEffect }, { "lattice:12", "vertex-shadows" } } };
  return scenes;
}

/// Throws Failure if the picture is not what it is to be, or rays went wrong in it.
void failOn(const Json& scene)
{
  for (const char* count : { "pixels_not_finite", "lost_rays", "guard_hits" })
  {
    if (scene[count] != 0)
    {
      throw Failure(std::string(count) + ": " + scene[count].dump());
    }
  }
  for (const char* differences : { "ground_truth", "cpu" })
  {
    if (scene[differences].is_null())
    {
      throw Failure("the picture is empty");
    }
  }
  const double most = scene["cpu"]["max"];
  if (most > scene["tolerance"])
  {
    throw Failure("pixels are up to " + std::to_string(most) + " from the CPU's");
  }
}

/// What the mappers of a benchmark, or its effects, stumbled over.
void addFailures(const Json& benchmark, Json& failures)
{
  for (const Json& dataset : benchmark["datasets"])
  {
    for (const char* list : { "mappers", "effects" })
    {
      for (const Json& one : dataset.value(list, Json::array()))
      {
        if (!one["failure"].is_null())
        {
          failures.push_back(dataset["name"].get<std::string>() + ", " +
                             one["name"].get<std::string>() + ": " +
                             one["failure"].get<std::string>());
        }
      }
    }
  }
}
} // namespace

GpuReport::GpuReport(const Options& options)
  : Asked(options)
{
  for (int& pixels : this->Asked.Size)
  {
    pixels = std::min(pixels, MostPixels);
  }
  this->Report = { { "format", Format }, { "date", currentDate() },
    { "tetmarch_version", TETMARCH_VERSION }, { "vtk_version", vtkVersion::GetVTKVersion() },
    { "os", operatingSystem() }, { "cpu", cpuModel() }, { "cpu_threads", hardwareThreads() },
    { "memory_bytes", memoryBytes() }, { "failures", Json::array() }, { "gl", nullptr },
    { "probes", nullptr }, { "parity", Json::array() }, { "benchmark", nullptr } };
}

void GpuReport::measure()
{
  this->attempt("GL", [this] { this->askForGL(); });
  for (const ParityScene& scene : parityScenes())
  {
    this->attempt("parity of " + scene.Dataset + ", " + scene.Effect,
      [&] { this->addParity(scene.Dataset, scene.Effect); });
  }
}

void GpuReport::attempt(const std::string& what, const std::function<void()>& step)
{
  std::fprintf(stderr, "%s\n", what.c_str());
  try
  {
    step();
  }
  catch (const std::exception& error)
  {
    this->Report["failures"].push_back(what + ": " + error.what());
    std::fprintf(stderr, "  %s\n", error.what());
  }
  this->write();
}

/// A driver that fails a probe has told of itself before.
void GpuReport::askForGL()
{
  ChildProcess child(workerArguments(this->Asked, { { "lattice:6", OwnFunctions }, "tetmarch" }));
  receiveAnswer(child, this->Asked.LimitSeconds);
  this->Report["gl"] = askWorker(child, "gl", this->Asked.LimitSeconds);
  this->Report["probes"] = askWorker(child, "probes", this->Asked.LimitSeconds);
}

void GpuReport::addParity(const std::string& dataset, const std::string& effect)
{
  this->Report["parity"].push_back({ { "dataset", dataset }, { "effect", effect },
    { "size", this->Asked.Size }, { "failure", nullptr } });
  Json& scene = this->Report["parity"].back();
  try
  {
    const double limit = ParityLimitFactor * this->Asked.LimitSeconds;
    ChildProcess child(workerArguments(this->Asked, { { dataset, OwnFunctions }, "tetmarch" }));
    receiveAnswer(child, limit);
    scene.update(Json(askWorker(child, "parity " + effect, limit)));
    failOn(scene);
  }
  catch (const std::exception& error)
  {
    scene["failure"] = error.what();
    throw;
  }
}

void GpuReport::setBenchmark(const Json& benchmark)
{
  this->Report["benchmark"] = benchmark;
  this->write();
}

void GpuReport::write() const
{
  Json report = this->Report;
  if (!report["benchmark"].is_null())
  {
    addFailures(report["benchmark"], report["failures"]);
  }
  WriteFile(this->Asked.GpuReportFile, report.dump(2) + "\n");
}
} // namespace tetmarch::bench
