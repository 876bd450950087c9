// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaseGroup.h"

#include "Grids.h"

#include <algorithm>

namespace tetmarch::testing
{
const std::vector<HardCase>& hardCases()
{
  static const std::vector<HardCase> cases = []
  {
    std::vector<HardCase> all;
    addRayCases(all);
    addCellCases(all);
    addScaleCases(all);
    addOpticsCases(all);
    addTransferFunctionCases(all);
    addNonConvexCases(all);
    return all;
  }();
  return cases;
}

const HardCase* findHardCase(const std::string& name)
{
  const std::vector<HardCase>& cases = hardCases();
  const auto found = std::find_if(
    cases.begin(), cases.end(), [&](const HardCase& hard) { return hard.Name == name; });
  return found == cases.end() ? nullptr : &*found;
}

std::vector<std::string> hardCaseNames()
{
  std::vector<std::string> names;
  for (const HardCase& hard : hardCases())
  {
    names.push_back(hard.Name);
  }
  return names;
}

std::vector<HardView> viewsOf(const HardCase& hard)
{
  return hard.Views.empty() ? standardViews() : hard.Views;
}

Grid jitteredCube() { return rounded(jitteredLattice(6), 1.0 / 1024.0); }
} // namespace tetmarch::testing
