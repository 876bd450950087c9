// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorText.h"

#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace tetmarch
{

ErrorText::ErrorText(vtkObject* source)
  : Source(source)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&this->Text);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* text, void* message)
    {
      std::string cleaned = CleanVTKMessage(static_cast<const char*>(message));
      const auto colon = cleaned.find(": ");
      *static_cast<std::string*>(text) =
        colon == std::string::npos ? cleaned : cleaned.substr(colon + 2);
    });
  this->Tag = source->AddObserver("ErrorEvent", command);
}

ErrorText::~ErrorText() { this->Source->RemoveObserver(this->Tag); }

} // namespace tetmarch
