// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionHistory.h"

namespace
{
// A state is a few kilobytes; this is more than anybody undoes.
constexpr std::size_t MaximumStates = 500;
} // namespace

namespace tetmarch
{

void FunctionHistory::Start(const FunctionSnapshot& state)
{
  this->States = { state };
  this->Present = 0;
  this->LastKind.clear();
}

void FunctionHistory::Record(const FunctionSnapshot& state, const std::string& kind)
{
  if (state == this->GetPresent())
  {
    return;
  }
  const bool continues = !kind.empty() && kind == this->LastKind && this->CanUndo();
  this->States.resize(this->Present + 1);
  this->LastKind = kind;
  if (continues)
  {
    this->States.back() = state;
    return;
  }
  this->States.push_back(state);
  if (this->States.size() > MaximumStates)
  {
    // The first one stays, since Reset goes back to it.
    this->States.erase(this->States.begin() + 1);
  }
  this->Present = this->States.size() - 1;
}

void FunctionHistory::ReplaceIsoValues(const std::vector<double>& isoValues)
{
  for (FunctionSnapshot& state : this->States)
  {
    state.IsoValues = isoValues;
  }
}

const FunctionSnapshot& FunctionHistory::Undo()
{
  --this->Present;
  this->LastKind.clear();
  return this->GetPresent();
}

const FunctionSnapshot& FunctionHistory::Redo()
{
  ++this->Present;
  this->LastKind.clear();
  return this->GetPresent();
}

} // namespace tetmarch
