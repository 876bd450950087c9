// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that are reported once, not in each frame.
#ifndef TetMarchMapperLastMessage_h
#define TetMarchMapperLastMessage_h

#include <string>

class vtkObject;

namespace tetmarch
{

class LastMessage
{
public:
  /** Whether to report `text`: it differs from the last one, and it is not empty. */
  bool changesTo(const std::string& text)
  {
    const bool changes = text != this->Text;
    this->Text = text;
    return changes && !text.empty();
  }

  /** Report `text` as an error or a warning of the mapper, if it changes to it. */
  void reportError(vtkObject* mapper, const std::string& text);
  void reportWarning(vtkObject* mapper, const std::string& text);

private:
  /** changesTo(), but what nobody hears, since VTK displays no warnings, is not reported by that.
   */
  bool isNews(const std::string& text);

  std::string Text;
};

} // namespace tetmarch

#endif
