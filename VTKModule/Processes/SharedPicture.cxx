// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/SharedPicture.h"

namespace tetmarch
{
namespace
{

std::string sizeOf(int width, int height)
{
  return std::to_string(width) + " x " + std::to_string(height);
}

} // namespace

bool anyOf(Group& group, bool own)
{
  vtkMultiProcessStream message;
  message << own;
  bool any = false;
  for (vtkMultiProcessStream& said : group.tellAll(message))
  {
    bool it = false;
    said >> it;
    any = any || it;
  }
  return any;
}

PartStatus agreeOn(Group& group, const PartStatus& own)
{
  vtkMultiProcessStream message;
  message << own.Error << own.Stopped << own.TooMuch << own.Waits << own.Width << own.Height;
  std::vector<vtkMultiProcessStream> said = group.tellAll(message);
  PartStatus all;
  PartStatus first;
  for (int p = 0; p < group.size(); ++p)
  {
    PartStatus part;
    said[p] >> part.Error >> part.Stopped >> part.TooMuch >> part.Waits >> part.Width >>
      part.Height;
    first = p == 0 ? part : first;
    if (all.Error.empty() && !part.Error.empty())
    {
      all.Error =
        group.size() > 1 ? "Process " + std::to_string(p) + ": " + part.Error : part.Error;
    }
    if (all.Error.empty() && (part.Width != first.Width || part.Height != first.Height))
    {
      all.Error = "The processes draw a volume together, but into viewports of different sizes: "
                  "process 0 has " +
                  sizeOf(first.Width, first.Height) + " pixels, process " + std::to_string(p) +
                  " has " + sizeOf(part.Width, part.Height) +
                  ". Give their windows and renderers the same size.";
    }
    all.Stopped = all.Stopped || part.Stopped;
    all.TooMuch = all.TooMuch || part.TooMuch;
    all.Waits = all.Waits || part.Waits;
  }
  all.Width = first.Width;
  all.Height = first.Height;
  return all;
}

} // namespace tetmarch
