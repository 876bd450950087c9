// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Failure.h"

#include <cstdlib>

namespace
{
bool IsSet(const char* variable)
{
  const char* value = std::getenv(variable);
  return value && *value;
}
} // namespace

namespace tetmarch
{

Arguments ParseArguments(const std::vector<std::string>& arguments)
{
  Arguments parsed;
  bool onlyFiles = false;
  for (const std::string& argument : arguments)
  {
    if (!onlyFiles && argument == "--help")
    {
      parsed.Help = true;
    }
    else if (!onlyFiles && argument == "--version")
    {
      parsed.Version = true;
    }
    else if (!onlyFiles && argument == "--")
    {
      onlyFiles = true;
    }
    else if (!onlyFiles && argument.size() > 1 && argument[0] == '-')
    {
      throw UsageError("unknown option " + argument);
    }
    else if (!parsed.File.empty())
    {
      throw UsageError("one file at a time, not '" + parsed.File + "' and '" + argument + "'");
    }
    else
    {
      parsed.File = argument;
    }
  }
  return parsed;
}

std::string GetViewHelp()
{
  return R"(Usage: tetmarch-view [FILE]

Draws an unstructured grid, an image or a rectilinear grid as a volume in a window, by marching each ray from
cell to cell. FILE is an INPUT of tetmarch-render, or a saved session of this program (.json). Files can also be
dropped on the window.

Mouse      left: turn; middle: move; right or wheel: zoom; click: pick
Keys       x y z: look along that axis; 5: parallel or perspective; r: reset the camera

  --help, --version

Exit status: 0 done, 1 failure, 2 bad command line.
)";
}

std::string FindDisplayProblem()
{
  if (IsSet("DISPLAY") || IsSet("WAYLAND_DISPLAY") || IsSet("QT_QPA_PLATFORM"))
  {
    return {};
  }
  return "there is no display for a window (neither DISPLAY nor WAYLAND_DISPLAY is set). Instead:\n"
         "  tetmarch-render FILE             writes a picture, and needs no display\n"
         "  ssh -X HOST tetmarch-view FILE   shows the window of another machine on yours\n"
         "  xvfb-run -a tetmarch-view FILE   runs with an invisible display, for tests";
}

} // namespace tetmarch
