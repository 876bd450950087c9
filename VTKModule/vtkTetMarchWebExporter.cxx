// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchWebExporter.h"

#include "Caching/WithinMemory.h"
#include "WebPage/Capture.h"
#include "WebPage/PageText.h"
#include "WebPage/SceneJson.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <sstream>
#include <system_error>

class vtkTetMarchWebExporter::Internals
{
public:
  void clear() { *this = Internals(); }
  void addOmission(const std::string& sentence)
  {
    if (std::find(this->Omissions.begin(), this->Omissions.end(), sentence) ==
        this->Omissions.end())
    {
      this->Omissions.push_back(sentence);
    }
  }

  tetmarch::PageArrays Arrays;
  Json::Value Steps{ Json::arrayValue };
  std::string FirstName; // of the arrays of volumes
  std::vector<std::string> Omissions;
};

vtkStandardNewMacro(vtkTetMarchWebExporter);

//------------------------------------------------------------------------------
vtkTetMarchWebExporter::vtkTetMarchWebExporter()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTetMarchWebExporter::~vtkTetMarchWebExporter()
{
  this->SetFileName(nullptr);
  this->SetTitle(nullptr);
}

//------------------------------------------------------------------------------
bool vtkTetMarchWebExporter::AddTimeStep(const char* label)
{
  vtkRenderer* renderer = this->ActiveRenderer ? this->ActiveRenderer
                          : this->RenderWindow
                            ? this->RenderWindow->GetRenderers()->GetFirstRenderer()
                            : nullptr;
  if (!renderer || !renderer->GetRenderWindow())
  {
    vtkErrorMacro("There is no scene to write. Call SetRenderWindow() with a window that has a "
                  "renderer.");
    return false;
  }
  std::string error = tetmarch::withinMemory("the page",
    [&]
    {
      const tetmarch::Capture capture = tetmarch::captureScene(renderer);
      for (const std::string& sentence : capture.Omissions)
      {
        this->Internal->addOmission(sentence);
      }
      if (!capture.Volumes.empty() && this->Internal->FirstName.empty())
      {
        this->Internal->FirstName = capture.Volumes.front().Name;
      }
      this->Internal->Steps.append(tetmarch::stepOf(
        label ? label : "", capture.Volumes, capture.Surfaces, this->Internal->Arrays));
    });
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkTetMarchWebExporter::ClearTimeSteps() { this->Internal->clear(); }

//------------------------------------------------------------------------------
std::string vtkTetMarchWebExporter::GetOmissions() const
{
  std::string lines;
  for (const std::string& sentence : this->Internal->Omissions)
  {
    lines += (lines.empty() ? "" : "\n") + sentence;
  }
  return lines;
}

//------------------------------------------------------------------------------
bool vtkTetMarchWebExporter::WritePage(ostream& stream)
{
  Internals& internal = *this->Internal;
  const bool captures = internal.Steps.empty();
  if (captures)
  {
    internal.clear(); // the omissions of the last page
    if (!this->AddTimeStep(""))
    {
      return false;
    }
  }
  vtkRenderer* renderer = this->ActiveRenderer
                            ? this->ActiveRenderer
                            : this->RenderWindow->GetRenderers()->GetFirstRenderer();
  const std::string title = this->Title ? this->Title : internal.FirstName;
  const std::string error = tetmarch::withinMemory("the page",
    [&]
    {
      Json::Value scene;
      tetmarch::addView(renderer, scene);
      scene["controls"] = this->Controls ? "all" : "none";
      scene["omissions"] = Json::Value(Json::arrayValue);
      for (const std::string& sentence : internal.Omissions)
      {
        scene["omissions"].append(sentence);
      }
      scene["steps"] = internal.Steps;
      tetmarch::writePage(title, scene, internal.Arrays, stream);
    });
  if (captures)
  {
    const std::vector<std::string> omissions = internal.Omissions;
    internal.clear();
    internal.Omissions = omissions;
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
std::string vtkTetMarchWebExporter::WriteToString()
{
  std::ostringstream stream;
  return this->WritePage(stream) ? stream.str() : std::string();
}

//------------------------------------------------------------------------------
void vtkTetMarchWebExporter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("The page has no path. Call SetFileName() with one that ends with .html.");
    return;
  }
  // An older page stays until the new one is complete.
  const std::string part = std::string(this->FileName) + ".part";
  vtksys::ofstream file(part.c_str(), std::ios::out | std::ios::binary);
  const bool written = file && this->WritePage(file);
  file.close();
  std::error_code error;
  if (!file)
  {
    error.assign(errno != 0 ? errno : EIO, std::generic_category());
  }
  else if (written)
  {
    std::filesystem::rename(part, this->FileName, error);
  }
  if (error)
  {
    vtkErrorMacro("The page " << this->FileName << " could not be written: " << error.message()
                              << ". Choose another folder, or free space there.");
  }
  if (error || !written)
  {
    vtksys::SystemTools::RemoveFile(part);
  }
}

//------------------------------------------------------------------------------
void vtkTetMarchWebExporter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Title: " << (this->Title ? this->Title : "(none)") << "\n";
  os << indent << "Controls: " << (this->Controls ? "On" : "Off") << "\n";
}
