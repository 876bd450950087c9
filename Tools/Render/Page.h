// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The page of --html.
 */
#ifndef tetmarch_Page_h
#define tetmarch_Page_h

#include "CommandLine.h"
#include "Picture.h"

#include "vtkNew.h"
#include "vtkTetMarchWebExporter.h"

#include <string>

namespace tetmarch
{

/// Does nothing if the command line doesn't ask for a page.
class Page
{
public:
  Page(const CommandLine& commandLine, const std::string& title);

  /// Takes what was drawn last, as a step in time with this label. Throws Failure.
  void Add(Picture& picture, const std::string& label = {});

  /// Writes all steps as WriteOutput() does, and tells what of them is not in the page. Throws
  /// Failure.
  void Write();

private:
  void TellOmissions() const;

  const CommandLine& Options;
  vtkNew<vtkTetMarchWebExporter> Exporter;
};

} // namespace tetmarch

#endif
