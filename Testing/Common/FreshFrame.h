// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The frame of a mesh or of a lattice, by the stages that need no GL
 */
#ifndef tetmarch_testing_FreshFrame_h
#define tetmarch_testing_FreshFrame_h

#include "Frame/FrameScene.h"
#include "Frame/FrameStages.h"
#include "Volume/StructuredVolume.h"
#include "Volume/TetVolume.h"

#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <memory>
#include <stdexcept>

namespace tetmarch::testing
{
/// Each stage runs for the first time, so that nothing in the frame is stale. A stage that shows
/// nothing doesn't stop those behind it.
class FreshFrame
{
public:
  /// Throws std::runtime_error with what is wrong.
  explicit FreshFrame(const FrameInput& input)
    : IsLattice(!vtkUnstructuredGrid::SafeDownCast(input.Drawn.Volume.Data))
    , Property(input.Volume->GetProperty())
  {
    DrawnScalars drawn;
    expectDone(this->Stages.updateGeometry(input, {}));
    expectDone(FrameStages::chooseScalars(input, drawn));
    expectDone(this->Stages.updateScalars(input, drawn));
    expectDone(this->Stages.updateRays(input));
    expectDone({ this->Stages.prepareEntrySearch() });
  }

  const TetVolume& volume() const { return this->Tets; }
  /// Its scene for the CPU, with tables for a level. The frame outlives it.
  std::unique_ptr<FrameScene> at(const AccuracyLevel& level, int width, int height) const
  {
    auto made = std::make_unique<FrameScene>(this->Stages, this->Property, level, false);
    made->scene().Width = width;
    made->scene().Height = height;
    return made;
  }

private:
  static void expectDone(const StageResult& result)
  {
    if (!result.Error.empty())
    {
      throw std::runtime_error(result.Error);
    }
  }

  bool IsLattice;
  TetVolume Tets;
  StructuredVolume Boxes;
  FrameStages Stages{ IsLattice ? static_cast<MarchedVolume&>(Boxes) : Tets };
  vtkVolumeProperty* Property;
};
} // namespace tetmarch::testing

#endif
