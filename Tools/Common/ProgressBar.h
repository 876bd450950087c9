// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The progress of a stage of the work: passed to a callback, else one line on stderr, if that is a
 * terminal. Within a stage that has a line, other stages show none.
 */
#ifndef tetmarch_ProgressBar_h
#define tetmarch_ProgressBar_h

#include <functional>
#include <string>

class vtkObject;

namespace tetmarch
{

/// Is told the stage and how much of it is done, 0 to 1; returns false to stop the work.
using ProgressReport = std::function<bool(const std::string& stage, double fraction)>;

class ProgressBar
{
public:
  /// Follows the ProgressEvents of source as long as both live. A source that is to stop is told so
  /// by vtkAlgorithm::SetAbortExecute().
  ProgressBar(std::string stage, vtkObject* source, ProgressReport report = {});
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Whether the report has asked to stop.
  bool IsStopped() const { return this->Stopped; }

  /// Wipe a bar that is showing, so that text can be printed.
  static void Clear();

  /// From now on there are no bars.
  static void Hide();

private:
  void Show(double fraction);

  std::string Stage;
  vtkObject* Source;
  ProgressReport Report;
  bool Stopped = false;
  unsigned long Tag = 0;
};

/// What a bar looks like: "reading  [#####     ] 50 %".
std::string FormatProgress(const std::string& stage, double fraction);

} // namespace tetmarch

#endif
