// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collects what an object reports, instead of having it printed
 */
#ifndef tetmarch_testing_ErrorWatch_h
#define tetmarch_testing_ErrorWatch_h

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>
#include <vector>

namespace tetmarch::testing
{
class ErrorWatch
{
public:
  explicit ErrorWatch(vtkObject* object)
    : Object(object)
  {
    this->Listener->Texts[0] = &this->Errors;
    this->Listener->Texts[1] = &this->Warnings;
    object->AddObserver(vtkCommand::ErrorEvent, this->Listener);
    object->AddObserver(vtkCommand::WarningEvent, this->Listener);
  }
  ~ErrorWatch() { this->Object->RemoveObserver(this->Listener); }
  ErrorWatch(const ErrorWatch&) = delete;
  ErrorWatch& operator=(const ErrorWatch&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  class Collector : public vtkCommand
  {
  public:
    static Collector* New() { return new Collector; }
    void Execute(vtkObject*, unsigned long event, void* text) override
    {
      this->Texts[event == vtkCommand::WarningEvent]->push_back(static_cast<const char*>(text));
    }
    std::vector<std::string>* Texts[2] = {};
  };

  vtkObject* Object;
  vtkNew<Collector> Listener;
};
} // namespace tetmarch::testing

#endif
