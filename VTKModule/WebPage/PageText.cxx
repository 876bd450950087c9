// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/PageText.h"

#include "WebPage/SceneJson.h"

#include "TetMarchShaderFiles.h"
#include "TetMarchWebPage.h"

#include <string_view>

namespace tetmarch
{
namespace
{

const char* const Symbols[] = {
#include "Variants/FeatureNames.inc"
};

// Those that a page needs: compute shaders and passes of several processes are not among them.
bool isOfPages(const std::string& name)
{
  return name.find(".comp.") == std::string::npos && name.find("visit") == std::string::npos;
}

int addShaders(PageArrays& arrays)
{
  Json::Value files;
  for (const ShaderFile& file : ShaderFiles)
  {
    if (isOfPages(file.Name))
    {
      files[file.Name] = file.Text;
    }
  }
  const std::string text = textOf(files);
  return arrays.add("uint8", text.data(), text.size(), 1);
}

std::string escaped(const std::string& text)
{
  std::string safe;
  for (const char c : text)
  {
    safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return safe;
}

} // namespace

void writePage(
  const std::string& title, Json::Value& scene, PageArrays& arrays, std::ostream& stream)
{
  scene["format"] = 1;
  scene["generator"] = "TetMarch " TETMARCH_VERSION;
  scene["title"] = title;
  scene["shaders"] = addShaders(arrays);
  scene["symbols"] = Json::Value(Json::arrayValue);
  for (const char* name : Symbols)
  {
    scene["symbols"].append(name);
  }
  scene["arrays"] = rowsOf(arrays);
  std::string_view rest = tetmarch_page;
  while (!rest.empty())
  {
    const std::size_t begin = rest.find("{{");
    const std::size_t end = begin == std::string_view::npos ? begin : rest.find("}}", begin);
    stream << rest.substr(0, end == std::string_view::npos ? rest.size() : begin);
    if (end == std::string_view::npos)
    {
      break;
    }
    const std::string_view name = rest.substr(begin + 2, end - begin - 2);
    if (name == "TITLE")
    {
      stream << escaped(title);
    }
    else if (name == "DATA")
    {
      stream << "<script type=\"application/json\" id=\"scene\">" << textOf(scene) << "</script>\n";
      arrays.write(stream);
    }
    else
    {
      stream << rest.substr(begin, end + 2 - begin);
    }
    rest.remove_prefix(end + 2);
  }
}

} // namespace tetmarch
