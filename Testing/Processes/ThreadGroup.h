// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Processes played by threads, so that tests of what they tell each other need no MPI.
#ifndef TetMarchTestingThreadGroup_h
#define TetMarchTestingThreadGroup_h

#include "Processes/Group.h"

#include <functional>

namespace tetmarch
{
namespace testing
{

/** Run the work in threads at once, each of which has a controller to the others. Throws what a
 * thread has thrown. */
void runControllers(
  int processes, const std::function<void(vtkMultiProcessController* controller)>& work);
/** The same with the group of each controller. */
void runTogether(int processes, const std::function<void(Group& group)>& work);

} // namespace testing
} // namespace tetmarch

#endif
