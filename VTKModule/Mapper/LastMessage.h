// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that are reported once, not in each frame.
#ifndef TetMarchMapperLastMessage_h
#define TetMarchMapperLastMessage_h

#include <string>

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

private:
  std::string Text;
};

} // namespace tetmarch

#endif
