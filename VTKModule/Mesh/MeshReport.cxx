// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshReport.h"

namespace tetmarch
{

std::string describe(const MeshReport& report)
{
  std::string text;
  const auto say = [&text](vtkIdType count, const char* what)
  {
    if (count > 0)
    {
      text += (text.empty() ? "" : " ") + std::to_string(count) + what;
    }
  };
  say(report.UnsupportedCells, " cells of types that can't be cut into tetrahedra were skipped.");
  say(report.DegenerateTetrahedra, " tetrahedra with a repeated point were dropped.");
  say(report.DuplicateTetrahedra, " tetrahedra that repeat another one were dropped.");
  say(report.NonManifoldFaces,
    " faces have more tetrahedra on one side than on the other; those left over end there.");
  say(report.FoldedFaces,
    " faces have both their tetrahedra on one side, since one is turned inside out; space that is "
    "covered more than once is drawn once.");
  return text;
}

} // namespace tetmarch
