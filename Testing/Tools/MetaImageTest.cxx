// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of MetaImage: each field that tells where and what values are; and headers that lie.
#include "ImageFileCase.h"

#include "vtkMetaImageReader.h"

namespace
{
using MetaImage = ImageFileCase;

std::string Header(const std::string& type, const std::string& fields)
{
  return "ObjectType = Image\nNDims = 3\nDimSize = 3 4 5\nElementType = " + type + "\n" + fields;
}

const std::string Local = "ElementDataFile = LOCAL\n";
} // namespace

TEST_F(MetaImage, ReadsEachType)
{
  const auto check = [&](int type, const std::string& little, const std::string& big,
                       const std::vector<std::string>& names)
  {
    for (const std::string& name : names)
    {
      for (const auto& [fields, bytes] :
        { std::pair<std::string, std::string>{ "BinaryDataByteOrderMSB = False\n", little },
          { "ElementByteOrderMSB = True\n", big }, { "BinaryDataByteOrderMSB : True\n", big },
          { "CompressedData = True\n", this->Deflate(little, false) },
          { "CompressedData = true\nElementByteOrderMSB = T\n", this->Deflate(big, true) },
          { "BinaryData = False\n", this->Text() } })
      {
        const std::string path = this->WriteText("a.mha", Header(name, fields) + Local + bytes);
        this->ExpectValues(this->Read(path), type, name + ", " + fields);
      }
    }
  };
  const auto checkOf = [&](auto value, int type, const std::vector<std::string>& names)
  {
    using Value = decltype(value);
    check(type, this->Bytes<Value>(false), this->Bytes<Value>(true), names);
  };
  checkOf(char(), VTK_SIGNED_CHAR, { "MET_CHAR", "MET_CHAR_ARRAY" });
  checkOf(char(), VTK_UNSIGNED_CHAR, { "MET_UCHAR" });
  checkOf(short(), VTK_SHORT, { "MET_SHORT" });
  checkOf(short(), VTK_UNSIGNED_SHORT, { "MET_USHORT", "MET_USHORT_ARRAY" });
  checkOf(int(), VTK_INT, { "MET_INT", "MET_LONG" });
  checkOf(int(), VTK_UNSIGNED_INT, { "MET_UINT", "MET_ULONG" });
  checkOf(static_cast<long long>(0), VTK_LONG_LONG, { "MET_LONG_LONG" });
  checkOf(static_cast<long long>(0), VTK_UNSIGNED_LONG_LONG, { "MET_ULONG_LONG" });
  checkOf(float(), VTK_FLOAT, { "MET_FLOAT" });
  checkOf(double(), VTK_DOUBLE, { "MET_DOUBLE" });
}

TEST_F(MetaImage, KeepsWhereValuesAre)
{
  const std::array<double, 9> straight{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };
  const std::array<double, 9> turned{ { 0, -1, 0, 0.6, 0, 0.8, 0.8, 0, -0.6 } };
  const std::array<double, 3> one{ { 1, 1, 1 } };
  for (const auto& [fields, spacing, origin, direction] :
    { std::tuple<std::string, std::array<double, 3>, std::array<double, 3>, std::array<double, 9>>{
        "", one, {}, straight },
      { "ElementSpacing = 0.5 2 3e0\nOffset = 1 -2 3\n", { { 0.5, 2, 3 } }, { { 1, -2, 3 } },
        straight },
      { "ElementSize = 4 5 6\nOrigin = 1 2 3\n", { { 4, 5, 6 } }, { { 1, 2, 3 } }, straight },
      { "ElementSize = 4 5 6\nElementSpacing = 1 2 3\nPosition = 7 8 9\n", { { 1, 2, 3 } },
        { { 7, 8, 9 } }, straight },
      { "TransformMatrix = 0 0.6 0.8 -1 0 0 0 0.8 -0.6\nElementSpacing = 2 3 5\n", { { 2, 3, 5 } },
        {}, turned },
      { "Rotation = 0 0.6 0.8 -1 0 0 0 0.8 -0.6\n", one, {}, turned },
      { "Orientation = 0 0.6 0.8 -1 0 0 0 0.8 -0.6\n", one, {}, turned } })
  {
    const std::string path =
      this->WriteText("a.mha", Header("MET_UCHAR", fields) + Local + this->Bytes<char>());
    this->ExpectGeometry(this->Read(path), spacing, origin, direction, fields);
  }
}

TEST_F(MetaImage, FindsValuesInOtherFiles)
{
  const std::string bytes = this->Bytes<char>();
  this->WriteText("all.raw", bytes);
  this->WriteText("after.raw", "four" + bytes);
  for (int slice = 0; slice < 5; ++slice)
  {
    this->WriteText("slice_0" + std::to_string(slice) + ".raw", bytes.substr(12 * slice, 12));
  }
  for (const char* fields :
    { "ElementDataFile = all.raw", "HeaderSize = 4\nElementDataFile = after.raw\n",
      "HeaderSize = -1\nElementDataFile = after.raw\n", "ElementDataFile = slice_%02d.raw 0 4 1\n",
      "ElementDataFile = "
      "LIST\nslice_00.raw\nslice_01.raw\nslice_02.raw\nslice_03.raw\nslice_04.raw\n",
      "ElementDataFile = LIST 3\n\nall.raw\n" })
  {
    const std::string path = this->WriteText("a.mhd", Header("MET_UCHAR", fields));
    this->ExpectValues(this->Read(path), VTK_UNSIGNED_CHAR, fields);
  }
  const std::string head =
    "ObjectType = Image\nNDims = 4\nDimSize = 2 2 5 1\nElementType = MET_UCHAR\n"
    "ElementNumberOfChannels = 3\nElementDataFile = all.raw\n";
  const auto image = this->Read(this->WriteText("a.mhd", head));
  this->ExpectValues(image, VTK_UNSIGNED_CHAR, "components");
  EXPECT_EQ(image->GetNumberOfScalarComponents(), 3);
}

TEST_F(MetaImage, IsReadAsVTKReadsIt)
{
  for (const std::string& fields : { std::string("ElementSpacing = 0.1 2 3.7\nOffset = 1 2 -3\n"),
         std::string(
           "Position = 4 5 6\nElementByteOrderMSB = True\nTransformMatrix = 0 1 0 1 0 0 0 0 1\n") })
  {
    const bool big = fields.find("MSB") != std::string::npos;
    ExpectWhatVTKReads<vtkMetaImageReader>(
      this->WriteText("a.mha", Header("MET_FLOAT", fields) + Local + this->Bytes<float>(big)));
    const std::string deflated = this->Deflate(this->Bytes<short>(big), false);
    ExpectWhatVTKReads<vtkMetaImageReader>(this->WriteText(
      "b.mha", Header("MET_USHORT", fields + "CompressedData = True\nCompressedDataSize = " +
                                      std::to_string(deflated.size()) + "\n") +
                 Local + deflated));
  }
}

TEST_F(MetaImage, SaysWhatIsWrong)
{
  const std::string bytes = this->Bytes<char>();
  const auto headed = [&](const std::string& fields)
  { return Header("MET_UCHAR", fields) + Local + bytes; };
  for (const auto& [text, words] :
    {
      std::pair<std::string, std::string>{ "", "no field 'ElementDataFile'" },
      { "this is no image", "'this is no image' in its header is no field" },
      { std::string(70000, 'x'), "more than 65536 characters" },
      { Header("MET_UCHAR", ""), "no field 'ElementDataFile'" },
      { "ObjectType = Tube\n" + Local, "a MetaIO file of 'Tube'" },
      { Header("MET_STRING", "") + Local + bytes, "of the type 'MET_STRING'" },
      { headed("NDims = 0\n"), "0 axes" },
      { headed("NDims = x\n"), "'x' is no number" },
      { headed("DimSize = 3 4\n"), "'DimSize' of its header has 2 numbers instead of 3" },
      { headed("DimSize = 3 4 -5\n"), "an axis has -5 values" },
      { headed("DimSize = 2147483646 2147483646 2147483646\n"), "than can be counted" },
      { headed("NDims = 4\nDimSize = 3 4 5 2\n"), "it has 4 axes" },
      { headed("ElementNumberOfChannels = 0\n"), "0 components" },
      { headed("ElementNumberOfChannels = 2\n"), "120 values of unsigned char" },
      { headed("ElementSpacing = 1 2 0\n"), "not 0" },
      { headed("ElementSpacing = 1 2 nan\n"), "must be finite" },
      { headed("Offset = 1 2\n"), "'Offset' of its header has 2 numbers" },
      { headed("TransformMatrix = 1 0 0 0 1 0\n"), "6 numbers instead of 9" },
      { headed("TransformMatrix = 1 0 0 0 1 0 1 1 0\n"), "in one plane" },
      { headed("ElementByteOrderMSB = maybe\n"), "'maybe', neither True nor False" },
      { headed("CompressedData = True\n"), "compressed values are damaged" },
      { headed("CompressedData = True\nHeaderSize = -1\n"), "'HeaderSize' of its header is -1" },
      { headed("HeaderSize = 9223372036854775807\n"), "are only 0" },
      { headed("BinaryData = False\n") + bytes, "which is no value of unsigned char" },
      { Header("MET_UCHAR", "") + Local + bytes.substr(1), "60 bytes, but there are only 59" },
      { Header("MET_UCHAR", "") + "ElementDataFile = ", "is no regular file" },
      { Header("MET_UCHAR", "") + "ElementDataFile = none.raw", "none.raw' isn't there" },
      { Header("MET_UCHAR", "") + "ElementDataFile = none_%03d.raw 1 5 1", "none_001.raw' isn't" },
      { Header("MET_UCHAR", "") + "ElementDataFile = LIST\na\nb\nc\nd\ne\nf\ng\n", "7 files" },
    })
  {
    this->ExpectError(this->WriteText("a.mha", text), words);
  }
}
