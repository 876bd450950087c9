// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include "ErrorText.h"
#include "Failure.h"
#include "Messages.h"
#include "Outputs.h"

#include <filesystem>
#include <sstream>

namespace tetmarch
{

Page::Page(const CommandLine& commandLine, const std::string& title)
  : Options(commandLine)
{
  const std::string file = std::filesystem::path(commandLine.Input).filename().string();
  this->Exporter->SetTitle((file + ": " + title).c_str());
  this->Exporter->SetControls(commandLine.HtmlControls);
}

void Page::Add(Picture& picture, const std::string& label)
{
  if (this->Options.Html.empty())
  {
    return;
  }
  const int errorsBefore = Messages::GetNumberOfErrors();
  const ErrorText error(this->Exporter);
  this->Exporter->SetRenderWindow(picture.GetWindow());
  if (!this->Exporter->AddTimeStep(label.c_str()))
  {
    throw Failure("no page: " + error.Get());
  }
  if (Messages::GetNumberOfErrors() > errorsBefore)
  {
    throw Failure("rendering failed");
  }
}

void Page::Write()
{
  if (this->Options.Html.empty())
  {
    return;
  }
  const ErrorText error(this->Exporter);
  const std::string text = this->Exporter->WriteToString();
  if (text.empty())
  {
    throw Failure("no page: " + error.Get());
  }
  WriteOutput(this->Options.Html, text);
  this->TellOmissions();
}

void Page::TellOmissions() const
{
  std::istringstream sentences(this->Exporter->GetOmissions());
  for (std::string sentence; std::getline(sentences, sentence);)
  {
    PrintMessage("warning", sentence);
  }
  if (this->Options.Transparent)
  {
    PrintMessage("warning", "The page has no opacities: its background is black.");
  }
}

} // namespace tetmarch
