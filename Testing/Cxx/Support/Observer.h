// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Calls a function at an object's events, as long as it lives
 */
#ifndef tetmarch_testing_Observer_h
#define tetmarch_testing_Observer_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <functional>

namespace tetmarch::testing
{
class Observer
{
public:
  Observer(vtkObject* object, unsigned long event, const std::function<void()>& call)
    : Object(object)
    , Call(call)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Observer*>(self)->Call(); });
    this->Object->AddObserver(event, this->Command);
  }
  ~Observer() { this->Object->RemoveObserver(this->Command); }
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

private:
  vtkObject* Object;
  std::function<void()> Call;
  vtkNew<vtkCallbackCommand> Command;
};
} // namespace tetmarch::testing

#endif
