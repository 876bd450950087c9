// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/MetaImageHeader.h"

#include "ImageFiles/HeaderText.h"

#include <fstream>
#include <map>

// The format: https://itk.org/Wiki/ITK/MetaIO/Documentation
namespace tetmarch
{
namespace
{

struct MetaImageFields
{
  std::map<std::string, std::string> Texts; // by the name in lower case
  std::vector<std::string> ListedFiles;
  std::uint64_t End = 0;

  // The value of the first of the names that exists.
  const std::string* find(std::initializer_list<const char*> names) const
  {
    for (const char* name : names)
    {
      const auto found = this->Texts.find(name);
      if (found != this->Texts.end())
      {
        return &found->second;
      }
    }
    return nullptr;
  }
  std::string get(std::initializer_list<const char*> names, const std::string& otherwise) const
  {
    const std::string* text = this->find(names);
    return text ? *text : otherwise;
  }
};

bool isList(const std::string& text) { return wordsOf(text + " ?")[0] == "LIST"; }

MetaImageFields readFields(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  MetaImageFields fields;
  std::string line;
  while (nextLine(file, line))
  {
    const std::size_t sign = line.find_first_of("=:");
    if (sign == std::string::npos && !trimmed(line).empty())
    {
      throw ImageFileError("'" + shown(line) + "' in its header is no field");
    }
    if (sign == std::string::npos)
    {
      continue;
    }
    const std::string name = lowered(trimmed(line.substr(0, sign)));
    const std::string text = trimmed(line.substr(sign + 1));
    fields.Texts[name] = text;
    if (name == "elementdatafile") // the last one
    {
      fields.End = file.eof() ? 0 : static_cast<std::uint64_t>(file.tellg());
      while (isList(text) && nextLine(file, line))
      {
        if (!trimmed(line).empty())
        {
          fields.ListedFiles.push_back(trimmed(line));
        }
      }
      return fields;
    }
  }
  throw ImageFileError("its header has no field 'ElementDataFile'");
}

int typeOf(const std::string& text)
{
  static const std::map<std::string, int> types = { { "MET_CHAR", VTK_SIGNED_CHAR },
    { "MET_UCHAR", VTK_UNSIGNED_CHAR }, { "MET_SHORT", VTK_SHORT },
    { "MET_USHORT", VTK_UNSIGNED_SHORT }, { "MET_INT", VTK_INT }, { "MET_UINT", VTK_UNSIGNED_INT },
    { "MET_LONG", VTK_INT }, { "MET_ULONG", VTK_UNSIGNED_INT }, // of 32 bits, as in MetaIO
    { "MET_LONG_LONG", VTK_LONG_LONG }, { "MET_ULONG_LONG", VTK_UNSIGNED_LONG_LONG },
    { "MET_FLOAT", VTK_FLOAT }, { "MET_DOUBLE", VTK_DOUBLE } };
  const std::string array = "_ARRAY";
  const bool ofArray = text.size() > array.size() &&
                       text.compare(text.size() - array.size(), array.size(), array) == 0;
  const auto type = types.find(ofArray ? text.substr(0, text.size() - array.size()) : text);
  if (type == types.end())
  {
    throw ImageFileError("its values are of the type '" + shown(text) + "', which isn't read");
  }
  return type->second;
}

bool isYes(const MetaImageFields& fields, std::initializer_list<const char*> names, bool otherwise)
{
  const std::string* text = fields.find(names);
  if (!text || text->empty())
  {
    return otherwise;
  }
  const char first = lowered(*text)[0];
  if (first != 't' && first != 'f' && first != 'y' && first != 'n' && first != '0' && first != '1')
  {
    throw ImageFileError("the field '" + std::string(*names.begin()) + "' of its header is '" +
                         shown(*text) + "', neither True nor False");
  }
  return first == 't' || first == 'y' || first == '1';
}

void takeAxes(const MetaImageFields& fields, ImageHeader& header)
{
  const std::int64_t axes = wholesOf("NDims", fields.get({ "ndims" }, ""), 1)[0];
  if (axes < 1 || axes > 10)
  {
    throw ImageFileError(
      "its header says that it has " + std::to_string(axes) + " axes; there can be 1 to 10");
  }
  const auto n = static_cast<std::size_t>(axes);
  std::vector<std::int64_t> sizes = wholesOf("DimSize", fields.get({ "dimsize" }, ""), n);
  while (sizes.size() > 3 && sizes.back() == 1)
  {
    sizes.pop_back();
  }
  if (sizes.size() > 3)
  {
    throw ImageFileError(
      "it has " + std::to_string(sizes.size()) + " axes; images that are drawn have up to three");
  }
  setDimensions(header, sizes);
  const std::string* spacings = fields.find({ "elementspacing", "elementsize" });
  const std::string* origin = fields.find({ "offset", "origin", "position" });
  const std::string* matrix = fields.find({ "transformmatrix", "rotation", "orientation" });
  const auto spacing =
    spacings ? realsOf("ElementSpacing", *spacings, n) : std::vector<double>(n, 1.0);
  const auto directions =
    matrix ? realsOf("TransformMatrix", *matrix, n * n) : std::vector<double>();
  const auto places = origin ? realsOf("Offset", *origin, n) : std::vector<double>(n, 0.0);
  std::vector<ImageVector> steps;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    ImageVector step{};
    step[axis] = spacing[axis];
    for (std::size_t k = 0; matrix && k < sizes.size(); ++k)
    {
      step[k] = directions[n * axis + k] * spacing[axis];
    }
    steps.push_back(step);
    header.Origin[axis] = places[axis];
  }
  setSteps(header, steps);
}

void takeFiles(const std::string& path, const MetaImageFields& fields, ImageHeader& header)
{
  const std::string& data = *fields.find({ "elementdatafile" });
  if (data == "LOCAL" || data == "Local" || data == "local")
  {
    header.Begin = fields.End;
    header.Files = { path };
    return;
  }
  std::vector<std::string> names =
    isList(data) ? fields.ListedFiles : namesOfPattern(wordsOf(data));
  if (names.empty())
  {
    names.push_back(isList(data) ? "" : data);
  }
  for (const std::string& name : names)
  {
    header.Files.push_back(besideHeader(path, name));
  }
}

} // namespace

ImageHeader readMetaImageHeader(const std::string& path)
{
  const MetaImageFields fields = readFields(path);
  const std::string object = fields.get({ "objecttype" }, "Image");
  if (lowered(object) != "image")
  {
    throw ImageFileError("it is a MetaIO file of '" + shown(object) + "', not of an image");
  }
  ImageHeader header;
  header.ArrayName = "MetaImage";
  header.Type = typeOf(fields.get({ "elementtype" }, ""));
  takeAxes(fields, header);
  const std::int64_t components =
    wholesOf("ElementNumberOfChannels", fields.get({ "elementnumberofchannels" }, "1"), 1)[0];
  if (components < 1 || components > 65536)
  {
    throw ImageFileError(
      "its header says that a value has " + std::to_string(components) + " components");
  }
  header.Components = static_cast<int>(components);
  checkCount(header);
  header.BigEndian = isYes(fields, { "elementbyteordermsb", "binarydatabyteordermsb" }, false);
  header.Encoding = isYes(fields, { "compresseddata" }, false) ? ImageEncoding::Deflated
                    : isYes(fields, { "binarydata" }, true)    ? ImageEncoding::Raw
                                                               : ImageEncoding::Text;
  const std::int64_t skip = wholesOf("HeaderSize", fields.get({ "headersize" }, "0"), 1)[0];
  takeFiles(path, fields, header);
  const bool atEnd = skip == -1 && header.Encoding == ImageEncoding::Raw;
  if (skip < 0 && !atEnd)
  {
    throw ImageFileError("the field 'HeaderSize' of its header is " + std::to_string(skip));
  }
  if (skip != 0)
  {
    header.Begin = atEnd ? header.Begin : static_cast<std::uint64_t>(skip); // of any file's begin
    header.ByteSkip = atEnd ? -1 : 0;
  }
  return header;
}

} // namespace tetmarch
