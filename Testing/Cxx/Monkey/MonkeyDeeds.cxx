// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MonkeyActions.h"
#include "Observer.h"

#include "vtkHardwareSelector.h"
#include "vtkSelection.h"

namespace tetmarch::testing
{
namespace
{
using Random = MonkeyRandom;

void selectIn(MonkeyScene& scene, int x0, int y0, int x1, int y1)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(x0, y0, x1, y1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
}
} // namespace

const std::vector<MonkeyDeed>& monkeyDeeds()
{
  static const std::vector<MonkeyDeed> table{
    { "released",
      [](MonkeyScene& scene, Random&) { scene.Mapper->ReleaseGraphicsResources(scene.Window); } },
    { "the volume taken out and put in",
      [](MonkeyScene& scene, Random&)
      {
        scene.Renderer->RemoveVolume(scene.Volume);
        scene.Window->Render();
        scene.Renderer->AddVolume(scene.Volume);
      } },
    { "another window, or another context of it",
      [](MonkeyScene& scene, Random& random)
      {
        const int which = random.below(12); // seldom, since all shaders are built anew
        if (which == 0)
        {
          scene.moveTo(makeWindow());
        }
        else if (which == 1)
        {
          scene.Window->Finalize();
        }
      } },
    { "the same frame again", [](MonkeyScene& scene, Random&) { scene.Window->Render(); } },
    { "a pick",
      [](MonkeyScene& scene, Random& random)
      {
        const int* size = scene.Window->GetSize();
        scene.Mapper->Pick(
          scene.Renderer, scene.Volume, random.below(size[0]), random.below(size[1]));
      } },
    { "a selection",
      [](MonkeyScene& scene, Random& random)
      {
        const int* size = scene.Window->GetSize();
        const int x = random.below(size[0]);
        const int y = random.below(size[1]);
        selectIn(scene, x, y, x + random.below(size[0] - x), y + random.below(size[1] - y));
      } },
    { "a frame that is aborted",
      [](MonkeyScene& scene, Random& random)
      {
        const double share = random.share();
        const Observer observer(scene.Mapper, vtkCommand::ProgressEvent,
          [&]
          {
            const double progress = scene.Mapper->GetProgress();
            scene.Window->SetAbortRender(progress > share && progress < 1.0);
          });
        const double before = scene.Mapper->GetMaxDrawTimeInSeconds();
        scene.Mapper->SetMaxDrawTimeInSeconds(1e-9);
        scene.Window->Render();
        scene.Mapper->SetMaxDrawTimeInSeconds(before);
      } },
    { "released while it is drawn",
      [](MonkeyScene& scene, Random&)
      {
        const Observer observer(scene.Mapper, vtkCommand::ProgressEvent,
          [&] { scene.Mapper->ReleaseGraphicsResources(scene.Window); });
        const double before = scene.Mapper->GetMaxDrawTimeInSeconds();
        scene.Mapper->SetMaxDrawTimeInSeconds(1e-9);
        scene.Window->Render();
        scene.Mapper->SetMaxDrawTimeInSeconds(before);
      } },
  };
  return table;
}
} // namespace tetmarch::testing
