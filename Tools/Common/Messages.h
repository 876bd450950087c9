// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * VTK's errors and warnings as lines on stderr.
 */
#ifndef tetmarch_Messages_h
#define tetmarch_Messages_h

#include "vtkOutputWindow.h"

#include <functional>
#include <string>

namespace tetmarch
{

/// The program in whose name messages are printed: tetmarch-render, unless told.
void SetProgramName(const std::string& name);
const std::string& GetProgramName();

/// Receives each message besides its being printed, in the thread that reports it.
using MessageListener = std::function<void(const std::string& kind, const std::string& text)>;
void SetMessageListener(MessageListener listener);

/**
 * Print one message, "tetmarch-render: kind: text". Ends a progress bar's line first.
 */
void PrintMessage(const std::string& kind, const std::string& text);

/**
 * The same with the kind "note", which can be switched off.
 */
void PrintNote(const std::string& text);

/**
 * From now on no notes and no progress bars; errors and warnings stay.
 */
void BeQuiet();

/**
 * VTK's text without source line and addresses: "vtkFoo: what happened".
 */
std::string CleanVTKMessage(const std::string& text);

/**
 * Takes over from vtkOutputWindow and vtkLogger. Errors are counted, each thread for itself.
 */
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  static void Install();
  static int GetNumberOfErrors() { return NumberOfErrors; }

  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayText(const char* text) override;
  void DisplayDebugText(const char* text) override;

private:
  static thread_local int NumberOfErrors;
};

} // namespace tetmarch

#endif
