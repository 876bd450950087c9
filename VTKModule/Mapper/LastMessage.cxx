// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/LastMessage.h"

#include "vtkObject.h"

namespace tetmarch
{

bool LastMessage::isNews(const std::string& text)
{
  const bool isHeard = text.empty() || vtkObject::GetGlobalWarningDisplay() != 0;
  return isHeard && this->changesTo(text);
}

void LastMessage::reportError(vtkObject* mapper, const std::string& text)
{
  if (this->isNews(text))
  {
    vtkErrorWithObjectMacro(mapper, << text);
  }
}

void LastMessage::reportWarning(vtkObject* mapper, const std::string& text)
{
  if (this->isNews(text))
  {
    vtkWarningWithObjectMacro(mapper, << text);
  }
}

} // namespace tetmarch
