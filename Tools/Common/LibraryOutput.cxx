// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LibraryOutput.h"

#include <iostream>

namespace tetmarch
{

LibraryOutput::LibraryOutput()
  : Cout(std::cout.rdbuf(this->Text.rdbuf()))
  , Cerr(std::cerr.rdbuf(this->Text.rdbuf()))
{
}

LibraryOutput::~LibraryOutput()
{
  std::cout.rdbuf(this->Cout);
  std::cerr.rdbuf(this->Cerr);
}

std::string LibraryOutput::GetFirstLine() const
{
  const std::string text = this->Text.str();
  return text.substr(0, text.find('\n'));
}

} // namespace tetmarch
