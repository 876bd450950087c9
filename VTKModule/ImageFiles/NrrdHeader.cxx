// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/NrrdHeader.h"

#include "ImageFiles/HeaderText.h"
#include "ImageFiles/NrrdAxes.h"
#include "ImageFiles/NrrdFields.h"

#include <map>

// The format: https://teem.sourceforge.net/nrrd/format.html
namespace tetmarch
{
namespace
{

int typeOf(const std::string& text)
{
  static const std::map<std::string, int> types = { { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "short int", VTK_SHORT },
    { "signed short", VTK_SHORT }, { "signed short int", VTK_SHORT }, { "int16", VTK_SHORT },
    { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "unsigned short", VTK_UNSIGNED_SHORT }, { "unsigned short int", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "signed int", VTK_INT }, { "int32", VTK_INT }, { "int32_t", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "longlong", VTK_LONG_LONG },
    { "long long", VTK_LONG_LONG }, { "long long int", VTK_LONG_LONG },
    { "signed long long", VTK_LONG_LONG }, { "signed long long int", VTK_LONG_LONG },
    { "int64", VTK_LONG_LONG }, { "int64_t", VTK_LONG_LONG },
    { "ulonglong", VTK_UNSIGNED_LONG_LONG }, { "unsigned long long", VTK_UNSIGNED_LONG_LONG },
    { "unsigned long long int", VTK_UNSIGNED_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };
  const auto type = types.find(lowered(text));
  if (type == types.end())
  {
    throw ImageFileError("its values are of the type '" + shown(text) + "', which isn't read");
  }
  return type->second;
}

ImageEncoding encodingOf(const std::string& text)
{
  static const std::map<std::string, ImageEncoding> encodings = { { "raw", ImageEncoding::Raw },
    { "txt", ImageEncoding::Text }, { "text", ImageEncoding::Text },
    { "ascii", ImageEncoding::Text }, { "hex", ImageEncoding::Hex },
    { "gz", ImageEncoding::Deflated }, { "gzip", ImageEncoding::Deflated } };
  const auto encoding = encodings.find(lowered(text));
  if (encoding == encodings.end())
  {
    throw ImageFileError("its values are in the encoding '" + shown(text) +
                         "', which is not read; write them in the encoding raw or gzip");
  }
  return encoding->second;
}

void takeFiles(const std::string& path, const NrrdFields& fields, ImageHeader& header)
{
  const std::string* data = fields.find("datafile");
  if (!data)
  {
    if (!fields.EndsByBlankLine)
    {
      throw ImageFileError("it ends in its header, before a blank line and the values");
    }
    header.Begin = fields.End;
    header.Files = { path };
    return;
  }
  std::vector<std::string> names =
    fields.IsList ? fields.ListedFiles : namesOfPattern(wordsOf(*data));
  if (names.empty())
  {
    names.push_back(fields.IsList ? "" : *data);
  }
  for (const std::string& name : names)
  {
    header.Files.push_back(besideHeader(path, name));
  }
}

std::int64_t skipOf(const NrrdFields& fields, const std::string& name, std::int64_t least)
{
  const std::string* text = fields.find(name);
  const std::int64_t skip = text ? wholesOf(name, *text, 1)[0] : 0;
  if (skip < least)
  {
    throw ImageFileError("the field '" + name + "' of its header is " + std::to_string(skip));
  }
  return skip;
}

} // namespace

ImageHeader readNrrdHeader(const std::string& path)
{
  const NrrdFields fields = readNrrdFields(path);
  ImageHeader header;
  header.Type = typeOf(fields.get("type"));
  setNrrdAxes(fields, header);
  checkCount(header);
  header.Encoding = encodingOf(fields.get("encoding"));
  // Named as in vtkNrrdReader.
  header.ArrayName = header.Encoding == ImageEncoding::Deflated ? "ImageScalars" : "ImageFile";
  const std::string* endian = fields.find("endian");
  header.BigEndian = endian && lowered(*endian) == "big";
  if (endian && !header.BigEndian && lowered(*endian) != "little")
  {
    throw ImageFileError(
      "the field 'endian' of its header is '" + shown(*endian) + "', neither little nor big");
  }
  header.LineSkip = skipOf(fields, "lineskip", 0);
  header.ByteSkip = skipOf(fields, "byteskip", header.Encoding == ImageEncoding::Raw ? -1 : 0);
  takeFiles(path, fields, header);
  return header;
}

} // namespace tetmarch
