// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a VTK object reports as an error, kept instead of printed.
 */
#ifndef tetmarch_ErrorText_h
#define tetmarch_ErrorText_h

#include <string>

class vtkObject;

namespace tetmarch
{

class ErrorText
{
public:
  /// Listens to the object's ErrorEvents as long as both live.
  explicit ErrorText(vtkObject* source);
  ErrorText(const ErrorText&) = delete;
  ErrorText& operator=(const ErrorText&) = delete;
  ~ErrorText();

  /// The last error, without source line, class and address; empty if there was none.
  const std::string& Get() const { return this->Text; }

private:
  vtkObject* Source;
  unsigned long Tag = 0;
  std::string Text;
};

} // namespace tetmarch

#endif
