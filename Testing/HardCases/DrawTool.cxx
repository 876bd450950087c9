// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// One hard case drawn by one mapper, in a process of its own, which the mapper may bring down.
#include "CaseOptics.h"
#include "Drawing.h"
#include "PictureCheck.h"

#include "OffscreenWindow.h"

#include "vtkRenderWindow.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
using namespace tetmarch::testing;

const char Usage[] = R"(usage: tetmarch-draw-hard-case CASE MAPPER FILE.png [VIEW]

Writes the picture of a case (tetmarch-hard-cases list) and prints as JSON how it compares with
that of the CPU in double precision. MAPPER is tetmarch, projected, bunyk or zsweep, or
ground-truth for the picture of the CPU itself; VIEW the name of a view of the case, if not the
first in which there is something to see. But for cases about optics, colours and opacities are
plain ramps.
)";

bool showsAnything(const Image& picture)
{
  return std::any_of(
    picture.Rgba.begin(), picture.Rgba.end(), [](float x) { return x > 16.0f / 255.0f; });
}

// The view of that name; without a name the first in which there is something to see, if any.
const HardView& findView(
  const HardCase& hard, const std::vector<HardView>& views, const std::string& name)
{
  const auto found = std::find_if(views.begin(), views.end(),
    [&](const HardView& view)
    {
      return name.empty() ? showsAnything(PictureCheck(hard, view).groundTruth())
                          : view.Name == name;
    });
  if (found == views.end() && !name.empty())
  {
    throw std::invalid_argument("the case has no view named " + name);
  }
  return found == views.end() ? views.front() : *found;
}

Drawn drawnBy(const std::string& mapper, const HardCase& hard, const HardView& view)
{
  std::string error;
  const auto window = tetmarch::MakeOffscreenWindow(sizeOf(view), sizeOf(view), &error);
  if (!window)
  {
    throw std::runtime_error(error);
  }
  return draw(hard, view, mapper, window);
}

void run(const std::string& name, const std::string& mapper, const std::string& file,
  const std::string& viewName)
{
  const HardCase* found = findHardCase(name);
  if (!found)
  {
    throw std::invalid_argument("there is no case named " + name);
  }
  HardCase hard = *found;
  if (hard.Group != "optics")
  {
    hard.SetOptics = withRamps(hard.SetOptics);
  }
  const std::vector<HardView> views = viewsOf(hard);
  const HardView& view = findView(hard, views, viewName);
  PictureCheck check(hard, view);
  Drawn drawn;
  const auto begin = std::chrono::steady_clock::now();
  if (mapper == "ground-truth")
  {
    drawn.Picture = check.groundTruth();
  }
  else
  {
    drawn = drawnBy(mapper, hard, view);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (!writePng(drawn.Picture, file))
  {
    throw std::runtime_error(file + " can't be written");
  }
  const PictureResult result = check.compare(drawn.Picture, drawn.Counters, boundsOfOthers());
  std::cout << nlohmann::json{ { "case", hard.Name }, { "view", view.Name }, { "mapper", mapper },
    { "seconds", seconds.count() }, { "pixels", drawn.Picture.Width * drawn.Picture.Height },
    { "wrong", result.OutOfBound + result.NotFinite }, { "worst", result.WorstError },
    { "messages", drawn.Messages } }
            << '\n';
}
} // namespace

int main(int argc, char** argv)
{
  if (argc != 4 && argc != 5)
  {
    std::cerr << Usage;
    return EXIT_FAILURE;
  }
  try
  {
    run(argv[1], argv[2], argv[3], argc == 5 ? argv[4] : "");
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
