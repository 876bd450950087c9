// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AppendedData.h"

#include "vtkCallbackCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkSetGet.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <sstream>
#include <string>

#ifdef __linux__
#include <dlfcn.h>
#endif

// The library of Plugin/Expat lies beside this one.
std::string tetmarch::remedyForAppendedData()
{
  std::string text = "write such files with inline data";
#ifdef __linux__
  Dl_info here;
  if (dladdr(reinterpret_cast<void*>(&tetmarch::findsAppendedData), &here) && here.dli_fname)
  {
    const std::string path = here.dli_fname;
    const std::string folder = path.substr(0, path.find_last_of('/') + 1);
    text = "start ParaView with LD_PRELOAD=" + folder +
           "libTetMarchExpat.so in its environment, or " + text;
  }
#endif
  return text;
}

namespace
{

bool readsItsOwnDocument()
{
  // VTK reads 4096 bytes at a time. A tag that was put off is parsed with the next ones, too late.
  const std::string data(3 * 4096, '0');
  std::istringstream file("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n"
                          "<AppendedData encoding=\"raw\">\n_" +
                          data + "</AppendedData></VTKFile>\n");
  vtkNew<vtkXMLDataParser> parser;
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  parser->AddObserver(vtkCommand::ErrorEvent, silence);
  parser->SetStream(&file);
  const bool parsed = parser->Parse() != 0;
  parser->SetStream(nullptr);
  vtkXMLDataElement* root = parser->GetRootElement();
  return parsed && root && root->FindNestedElementWithName("AppendedData");
}

} // namespace

bool tetmarch::findsAppendedData()
{
  static const bool finds = readsItsOwnDocument(); // nothing in the process changes it
  return finds;
}

void tetmarch::warnIfAppendedDataIsLost()
{
  static bool said = false;
  auto* processes = vtkMultiProcessController::GetGlobalController();
  if (said || (processes && processes->GetLocalProcessId() != 0) || findsAppendedData())
  {
    return;
  }
  said = true;
  vtkGenericWarningMacro(
    "This ParaView loses data together with this version of libexpat: XML files of VTK with "
    "appended data (.vtu, .vti and others, as ParaView writes them by default) are read as 0 "
    "cells, and processes lose cells when data is redistributed. The remedy: "
    << remedyForAppendedData() << ".");
}
