// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/LastMessage.h"

#include "vtkObject.h"

namespace tetmarch
{

void LastMessage::reportError(vtkObject* mapper, const std::string& text)
{
  if (this->changesTo(text))
  {
    vtkErrorWithObjectMacro(mapper, << text);
  }
}

void LastMessage::reportWarning(vtkObject* mapper, const std::string& text)
{
  if (this->changesTo(text))
  {
    vtkWarningWithObjectMacro(mapper, << text);
  }
}

} // namespace tetmarch
