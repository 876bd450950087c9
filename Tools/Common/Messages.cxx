// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "ProgressBar.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <regex>

namespace
{
bool Quiet = false;
std::string ProgramName = "tetmarch-render";

struct
{
  std::mutex Mutex;
  tetmarch::MessageListener Listener;
} Listening;

constexpr int MostTimes = 10;

struct
{
  std::mutex Mutex;
  std::string Text;
  int Times = 0;
} Last;

// How often VTK has said this by now without saying anything else.
int CountTimes(const char* text)
{
  const std::lock_guard<std::mutex> lock(Last.Mutex);
  if (Last.Text != text)
  {
    Last.Text = text;
    Last.Times = 0;
  }
  Last.Times = std::min(Last.Times + 1, MostTimes + 2);
  return Last.Times;
}

// Readers say of some damaged files the same a million times.
void PrintUnlessRepeated(const char* kind, const char* text)
{
  const int times = CountTimes(text);
  if (times <= MostTimes)
  {
    tetmarch::PrintMessage(kind, tetmarch::CleanVTKMessage(text));
  }
  else if (times == MostTimes + 1)
  {
    tetmarch::PrintNote("VTK says the same more often");
  }
}
} // namespace

namespace tetmarch
{

void SetProgramName(const std::string& name) { ProgramName = name; }

const std::string& GetProgramName() { return ProgramName; }

void SetMessageListener(MessageListener listener)
{
  const std::lock_guard<std::mutex> lock(Listening.Mutex);
  Listening.Listener = std::move(listener);
}

void PrintMessage(const std::string& kind, const std::string& text)
{
  ProgressBar::Clear();
  std::fprintf(stderr, "%s: %s: %s\n", ProgramName.c_str(), kind.c_str(), text.c_str());
  const std::lock_guard<std::mutex> lock(Listening.Mutex);
  if (Listening.Listener)
  {
    Listening.Listener(kind, text);
  }
}

void PrintNote(const std::string& text)
{
  if (!Quiet)
  {
    PrintMessage("note", text);
  }
}

void BeQuiet()
{
  Quiet = true;
  ProgressBar::Hide();
}

std::string CleanVTKMessage(const std::string& text)
{
  static const std::regex place("^[A-Za-z ]+: In [^\n]*, line [0-9]+\n");
  static const std::regex address(" \\((0x)?[0-9a-fA-F]{6,}\\)");
  std::string message = std::regex_replace(text, place, "");
  message = std::regex_replace(message, address, "", std::regex_constants::format_first_only);
  message.erase(message.find_last_not_of(" \n\r\t") + 1);
  return message;
}

thread_local int Messages::NumberOfErrors = 0;

vtkStandardNewMacro(Messages);

void Messages::Install()
{
  vtkNew<Messages> messages;
  vtkOutputWindow::SetInstance(messages);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void Messages::DisplayErrorText(const char* text)
{
  ++NumberOfErrors;
  // The executive repeats, with a dump of its request, that an algorithm failed. That one has said
  // why.
  if (std::strstr(text, "returned failure for request"))
  {
    return;
  }
  PrintUnlessRepeated("error", text);
}

void Messages::DisplayWarningText(const char* text) { PrintUnlessRepeated("warning", text); }

void Messages::DisplayGenericWarningText(const char* text)
{
  // Readers of legacy files warn of errors, and go on with values that they have not read.
  const char* error = std::strstr(text, "Error reading");
  const bool isError = error && (error == text || error[-1] == '\n');
  isError ? this->DisplayErrorText(text) : this->DisplayWarningText(text);
}

void Messages::DisplayText(const char* text) { PrintNote(CleanVTKMessage(text)); }

void Messages::DisplayDebugText(const char* text) { this->DisplayText(text); }

} // namespace tetmarch
