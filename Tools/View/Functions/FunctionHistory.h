// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_FunctionHistory_h
#define tetmarch_FunctionHistory_h

#include "FunctionSnapshot.h"

#include <string>
#include <vector>

namespace tetmarch
{

/// The states of the functions, one after the other, and which of them is the present one.
class FunctionHistory
{
public:
  /// Forgets all that was, and begins with a state.
  void Start(const FunctionSnapshot& state);

  /**
   * A state after the present one; what was undone is forgotten. Nothing happens if the state is
   * the present one. Steps with the same kind that follow each other are one, so that a spin box
   * that runs through a hundred values is undone at once; a step without a kind stays alone.
   */
  void Record(const FunctionSnapshot& state, const std::string& kind = "");

  /// For isovalues that somebody else has chosen: no step leads away from them.
  void ReplaceIsoValues(const std::vector<double>& isoValues);

  bool CanUndo() const { return this->Present > 0; }
  bool CanRedo() const { return this->Present + 1 < this->States.size(); }

  /// The state before the present one, or after it. Call these only if there is such a state.
  const FunctionSnapshot& Undo();
  const FunctionSnapshot& Redo();

  const FunctionSnapshot& GetPresent() const { return this->States[this->Present]; }
  const FunctionSnapshot& GetFirst() const { return this->States.front(); }

private:
  std::vector<FunctionSnapshot> States = { {} };
  std::size_t Present = 0;
  std::string LastKind;
};

} // namespace tetmarch

#endif
