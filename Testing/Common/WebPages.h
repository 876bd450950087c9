// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes of tests as web pages, beside the mapper's pictures of them
 */
#ifndef tetmarch_testing_WebPages_h
#define tetmarch_testing_WebPages_h

#include "vtkTetMarchWebExporter.h"

#include "Images.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tetmarch::testing
{
/// What a page leaves out that changes its picture: a sentence per line. That a mapper draws
/// nothing shows in both pictures; lights that follow the camera are right until it moves.
inline std::string missingIn(const vtkTetMarchWebExporter* exporter, vtkRenderWindow* window)
{
  const double* viewport = window->GetRenderers()->GetFirstRenderer()->GetViewport();
  if (viewport[0] > 0 || viewport[1] > 0 || viewport[2] < 1 || viewport[3] < 1)
  {
    return "A page has no viewport: its picture fills the canvas.";
  }
  std::istringstream sentences(exporter->GetOmissions());
  std::string missing;
  for (std::string sentence; std::getline(sentences, sentence);)
  {
    if (sentence.find("its mapper has nothing to draw") == std::string::npos &&
        sentence.find("Lights that follow the camera") == std::string::npos)
    {
      missing += sentence + '\n';
    }
  }
  return missing;
}

/// Writes NAME.html and NAME.png, the picture, into the folder that TETMARCH_WEB_PAGES names; does
/// nothing without it. Says so if the page leaves out what the picture shows, and writes none. It
/// renders the window: read the last frame's figures before.
inline void keepWebPage(vtkRenderWindow* window, const Image& picture, const std::string& name)
{
  const char* folder = std::getenv("TETMARCH_WEB_PAGES");
  if (!folder)
  {
    return;
  }
  const std::string path =
    folder + ('/' + std::regex_replace(name, std::regex("[^-.A-Za-z0-9]"), "_"));
  vtkNew<vtkTetMarchWebExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName((path + ".html").c_str());
  exporter->ControlsOff();
  exporter->Write();
  const std::string missing = missingIn(exporter, window);
  if (!missing.empty())
  {
    std::remove((path + ".html").c_str());
    std::cout << "[ NO PAGE  ] " << name << ": " << missing;
  }
  else if (!writePng(picture, path + ".png"))
  {
    throw std::runtime_error(path + ".png can't be written");
  }
}
} // namespace tetmarch::testing

#endif
