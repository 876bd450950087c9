// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The groups of cases, and what they are put together with
 */
#ifndef tetmarch_testing_CaseGroup_h
#define tetmarch_testing_CaseGroup_h

#include "HardCase.h"

#include <string>
#include <utility>
#include <vector>

namespace tetmarch::testing
{
void addRayCases(std::vector<HardCase>& cases);
void addCellCases(std::vector<HardCase>& cases);
void addScaleCases(std::vector<HardCase>& cases);
void addOpticsCases(std::vector<HardCase>& cases);
void addTransferFunctionCases(std::vector<HardCase>& cases);
void addNonConvexCases(std::vector<HardCase>& cases);

/// Appends cases of one group.
class CaseGroup
{
public:
  CaseGroup(std::vector<HardCase>& cases, std::string name)
    : Cases(cases)
    , Name(std::move(name))
  {
  }

  /// The reference lasts until the next case is added.
  HardCase& add(const std::string& name, const std::string& what, std::function<Grid()> make)
  {
    HardCase hard;
    hard.Name = name;
    hard.Group = this->Name;
    hard.What = what;
    hard.Make = std::move(make);
    this->Cases.push_back(std::move(hard));
    return this->Cases.back();
  }

private:
  std::vector<HardCase>& Cases;
  std::string Name;
};

/// The case says that its cells fill that box.
inline HardCase& fills(HardCase& hard, const Box& box = { { 0, 0, 0 }, { 1, 1, 1 } })
{
  hard.Known = Answer::Box;
  hard.ExactBox = box;
  return hard;
}

/// The mesh that several cases start from: "jittered-cube", the unit cube in 6^3 cubes of
/// tetrahedra with coordinates that are multiples of 1/1024.
Grid jitteredCube();
} // namespace tetmarch::testing

#endif
