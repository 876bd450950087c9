// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/NrrdFields.h"

#include "ImageFiles/HeaderText.h"
#include "ImageFiles/ImageHeader.h"

#include <algorithm>
#include <fstream>

namespace tetmarch
{
namespace
{

void addField(NrrdFields& fields, const std::string& line)
{
  const std::size_t colon = line.find(':');
  if (colon == std::string::npos)
  {
    throw ImageFileError("'" + shown(line) + "' in its header is no field");
  }
  if (line.compare(colon, 2, ":=") == 0)
  {
    return; // a comment
  }
  std::string name = lowered(line.substr(0, colon));
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  fields.Texts[name] = trimmed(line.substr(colon + 1));
}

} // namespace

const std::string* NrrdFields::find(const std::string& name) const
{
  const auto found = this->Texts.find(name);
  return found == this->Texts.end() ? nullptr : &found->second;
}

const std::string& NrrdFields::get(const std::string& name) const
{
  const std::string* text = this->find(name);
  if (!text)
  {
    throw ImageFileError("its header has no field '" + name + "'");
  }
  return *text;
}

NrrdFields readNrrdFields(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  char magic[4] = {};
  file.read(magic, 4);
  NrrdFields fields;
  std::string line;
  if (std::string(magic, 4) != "NRRD" || !nextLine(file, line))
  {
    throw ImageFileError("it does not begin as an NRRD file does");
  }
  while (nextLine(file, line))
  {
    if (fields.IsList && !line.empty())
    {
      fields.ListedFiles.push_back(trimmed(line));
      continue;
    }
    if (line.empty())
    {
      fields.EndsByBlankLine = true;
      fields.End = static_cast<std::uint64_t>(file.tellg());
      break;
    }
    if (line[0] != '#')
    {
      addField(fields, line);
      const std::string* data = fields.find("datafile");
      fields.IsList = data && wordsOf(*data + " ?")[0] == "LIST";
    }
  }
  return fields;
}

} // namespace tetmarch
