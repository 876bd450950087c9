// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One line on stderr while a stage of the work runs; nothing if stderr is no terminal. Within a
 * stage that has a bar, other stages show none.
 */
#ifndef tetmarch_ProgressBar_h
#define tetmarch_ProgressBar_h

#include <string>

class vtkObject;

namespace tetmarch
{

class ProgressBar
{
public:
  /// Follows the ProgressEvents of source as long as both live.
  ProgressBar(std::string stage, vtkObject* source);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Wipe a bar that is showing, so that text can be printed.
  static void Clear();

  /// From now on there are no bars.
  static void Hide();

private:
  void Show(double fraction) const;

  std::string Stage;
  vtkObject* Source;
  unsigned long Tag = 0;
};

/// What a bar looks like: "reading  [#####     ] 50 %".
std::string FormatProgress(const std::string& stage, double fraction);

} // namespace tetmarch

#endif
