// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of NRRD: each encoding, type and field; and headers that lie.
#include "ImageFileCase.h"

#include "vtkNrrdReader.h"

namespace
{
using Nrrd = ImageFileCase;

const std::string Sizes = "dimension: 3\nsizes: 3 4 5\n";
const std::string Bytes3 = "NRRD0005\ntype: uchar\nencoding: raw\n" + Sizes;

constexpr std::array<double, 9> Straight{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };
} // namespace

TEST_F(Nrrd, ReadsEachEncoding)
{
  for (const bool big : { false, true })
  {
    const std::string bytes = this->Bytes<short>(big);
    const std::string endian = std::string("endian: ") + (big ? "big" : "little") + "\n";
    for (const auto& [encoding, coded] :
      { std::pair<std::string, std::string>{ "raw", bytes }, { "RAW", bytes },
        { "gzip", this->Deflate(bytes, true) }, { "gz", this->Deflate(bytes, false) },
        { "gz", this->Deflate(bytes.substr(0, 50), true) + this->Deflate(bytes.substr(50), true) },
        { "hex", this->Hex(bytes) }, { "ascii", this->Text() }, { "text", this->Text() },
        { "txt", this->Text() } })
    {
      const std::string head = "NRRD0001\n# a comment\ntype: short\nnote:=sizes: 7\n" + endian;
      const std::string path =
        this->WriteText("a.nrrd", head + Sizes + "Encoding: " + encoding + "\n\n" + coded);
      this->ExpectValues(this->Read(path), VTK_SHORT, encoding);
    }
  }
}

TEST_F(Nrrd, ReadsEachTypeByEachOfItsNames)
{
  const auto check = [&](int type, const std::string& bytes, const std::vector<std::string>& names)
  {
    for (const std::string& name : names)
    {
      const std::string path = this->WriteText(
        "a.nrrd", "NRRD0004\r\n" + Sizes + "endian: little\r\nencoding: raw\r\ntype: " + name +
                    "\r\n\r\n" + bytes);
      this->ExpectValues(this->Read(path), type, name);
    }
  };
  check(VTK_SIGNED_CHAR, this->Bytes<signed char>(), { "signed char", "int8", "int8_t" });
  check(VTK_UNSIGNED_CHAR, this->Bytes<char>(), { "uchar", "unsigned char", "uint8", "uint8_t" });
  check(VTK_SHORT, this->Bytes<short>(),
    { "short", "short int", "signed short", "signed short int", "int16", "int16_t" });
  check(VTK_UNSIGNED_SHORT, this->Bytes<short>(),
    { "ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t" });
  check(VTK_INT, this->Bytes<int>(), { "int", "signed int", "int32", "int32_t" });
  check(VTK_UNSIGNED_INT, this->Bytes<int>(), { "uint", "unsigned int", "uint32", "uint32_t" });
  check(VTK_LONG_LONG, this->Bytes<long long>(),
    { "longlong", "long long", "long long int", "signed long long", "signed long long int", "int64",
      "int64_t" });
  check(VTK_UNSIGNED_LONG_LONG, this->Bytes<long long>(),
    { "ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t" });
  check(VTK_FLOAT, this->Bytes<float>(), { "float" });
  check(VTK_DOUBLE, this->Bytes<double>(), { "double" });
}

TEST_F(Nrrd, KeepsWhereValuesAre)
{
  struct Case
  {
    const char* Fields;
    std::array<double, 3> Spacing, Origin;
    std::array<double, 9> Direction;
  };
  const std::array<double, 9> turned{ { 0, -1, 0, 0.6, 0, 0.8, 0.8, 0, -0.6 } };
  const std::array<double, 9> mirrored{ { 1, 0, 0, 0, -1, 0, 0, 0, 1 } };
  for (const Case& c : { Case{ "", { { 1, 1, 1 } }, {}, Straight },
         { "spacings: 0.5 nan 3e0\n", { { 0.5, 1, 3 } }, {}, Straight },
         { "spacings: 1 -2 3\n", { { 1, 2, 3 } }, {}, mirrored },
         { "axis mins: 1 2 3\naxismaxs: 7 10 13\n", { { 2, 2, 2 } }, { { 2, 3, 4 } }, Straight },
         { "axismins: 1 2 3\naxis maxs: 5 8 11\ncenters: node node node\n", { { 2, 2, 2 } },
           { { 1, 2, 3 } }, Straight },
         { "axismins: 1 2 nan\nspacings: 4 4 4\ncenterings: node cell ???\n", { { 4, 4, 4 } },
           { { 1, 4, 0 } }, Straight },
         { "space: RAS\nspace origin: (7,8, 9)\nspace directions: (0,0.6,0.8) ( -2,0,0)(0,4,-3)\n",
           { { 1, 2, 5 } }, { { 7, 8, 9 } }, turned },
         { "space dimension: 3\nspace directions: (0.25,0,0) (0,0.5,0) (0,0,1)\n",
           { { 0.25, 0.5, 1 } }, {}, Straight } })
  {
    const std::string path =
      this->WriteText("a.nrrd", Bytes3 + c.Fields + "\n" + this->Bytes<char>());
    ExpectGeometry(this->Read(path), c.Spacing, c.Origin, c.Direction, c.Fields);
  }
}

TEST_F(Nrrd, FindsComponents)
{
  for (const auto& [fields, components, nx] :
    { std::tuple<std::string, int, int>{ "dimension: 4\nsizes: 3 2 2 5\n", 3, 2 },
      { "dimension: 4\nsizes: 3 2 2 5\nkinds: vector domain domain domain\n", 3, 2 },
      { "dimension: 4\nsizes: 3 2 2 5\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n", 3, 2 },
      { "dimension: 4\nsizes: 1 3 4 5\n", 1, 3 },
      { "dimension: 4\nsizes: 3 4 5 1\nkinds: domain domain domain time\n", 1, 3 },
      { "dimension: 5\nsizes: 3 4 1 5 1\n", 1, 3 } })
  {
    const std::string path = this->WriteText(
      "a.nrrd", "NRRD0004\ntype: uchar\nencoding: raw\n" + fields + "\n" + this->Bytes<char>());
    const auto image = this->Read(path);
    this->ExpectValues(image, VTK_UNSIGNED_CHAR, fields);
    ASSERT_NE(image, nullptr);
    EXPECT_EQ(image->GetNumberOfScalarComponents(), components) << fields;
    EXPECT_EQ(image->GetDimensions()[0], nx) << fields;
  }
}

TEST_F(Nrrd, FindsValuesInOtherFiles)
{
  const std::string bytes = this->Bytes<char>();
  this->WriteText("all.raw", bytes);
  this->WriteText("skip.raw", "one\ntwo\n123" + bytes);
  this->WriteText("end.raw", "a header\nof any length" + bytes);
  for (int slice = 0; slice < 5; ++slice)
  {
    this->WriteText(
      "slice" + std::to_string(10 - 2 * slice) + ".raw", bytes.substr(12 * slice, 12));
    this->WriteText("slice_00" + std::to_string(slice) + ".raw", bytes.substr(12 * slice, 12));
  }
  for (const char* fields : { "data file: all.raw\n", "datafile: ./all.raw",
         "Data File: skip.raw\nline skip: 2\nbyteskip: 3", "data file: end.raw\nbyte skip: -1\n",
         "data file: slice_%03d.raw 0 4 1", "data file: slice%d.raw 10 2 -2 2\n\n",
         "data file: LIST "
         "2\nslice_000.raw\nslice_001.raw\nslice_002.raw\nslice_003.raw\nslice_004.raw" })
  {
    const std::string path = this->WriteText("a.nhdr", Bytes3 + fields);
    this->ExpectValues(this->Read(path), VTK_UNSIGNED_CHAR, fields);
  }
  const std::string skip = "line skip: 1\nbyte skip: 2\n\nfirst line\n";
  this->ExpectValues(this->Read(this->WriteText("skip.nrrd", Bytes3 + skip + "xx" + bytes)),
    VTK_UNSIGNED_CHAR, "skipped bytes");
  const std::string deflated = this->Deflate("xx" + bytes, true);
  this->ExpectValues(this->Read(this->WriteText("skip.nrrd",
                       "NRRD0002\ntype: uchar\nencoding: gz\n" + Sizes + skip + deflated)),
    VTK_UNSIGNED_CHAR, "skipped inflated bytes");
}

TEST_F(Nrrd, IsReadAsVTKReadsIt)
{
  // vtkNrrdReader takes a first axis of less than 10 values for components, and doesn't swap the
  // bytes of deflated values.
  const std::string head = "NRRD0004\ndimension: 3\nsizes: 10 3 2\n";
  ExpectWhatVTKReads<vtkNrrdReader>(this->WriteText(
    "a.nrrd", head + "endian: big\ntype: float\nencoding: raw\nspacings: 0.1 2 3.7\n\n" +
                this->Bytes<float>(true)));
  ExpectWhatVTKReads<vtkNrrdReader>(this->WriteText(
    "b.nrrd", head +
                "endian: little\ntype: ushort\nencoding: gzip\nspace: RAS\nspace origin: (1,2,3)\n"
                "space directions: (0.6,0.8,0) (0,3,0) (0,0,7)\n\n" +
                this->Deflate(this->Bytes<short>(), true)));
}

TEST_F(Nrrd, SaysWhatIsWrong)
{
  const std::string bytes = this->Bytes<char>();
  const std::string start = "NRRD0005\n";
  const std::string raw = start + "encoding: raw\n";
  const std::string typed = raw + "type: uchar\n";
  this->WriteText("three.raw", "abc");
  std::filesystem::create_directories(this->Folder / "folder.raw");
  for (const auto& [text, words] :
    {
      std::pair<std::string, std::string>{ "", "does not begin as an NRRD file" },
      { "NRRX", "does not begin as" },
      { start, "no field 'type'" },
      { start + std::string(70000, 'x'), "more than 65536 characters" },
      { start + "what is this?\n", "'what is this?' in its header is no field" },
      { raw + Sizes + "\n" + bytes, "no field 'type'" },
      { start + "type: uchar\n" + Sizes + "\n" + bytes, "no field 'encoding'" },
      { typed + "sizes: 3 4 5\n\n" + bytes, "no field 'dimension'" },
      { typed + "dimension: 3\n\n" + bytes, "no field 'sizes'" },
      { typed + "dimension: many\n" + "sizes: 3 4 5\n\n", "'many' is no number" },
      { typed + "dimension: 17\n" + "sizes: 3 4 5\n\n", "17 dimensions" },
      { typed + "dimension: 3\nsizes: 3 4\n\n" + bytes, "'sizes' of its header has 2 numbers" },
      { typed + "dimension: 3\nsizes: 3 -4 5\n\n" + bytes, "an axis has -4 values" },
      { typed + "dimension: 3\nsizes: 3 0 5\n\n" + bytes, "an axis has 0 values" },
      { typed + "dimension: 3\nsizes: 3 4 9999999999\n\n" + bytes, "axis has 9999999999 values" },
      { typed + "dimension: 3\nsizes: 3 4 99999999999999999999\n\n", "is no number" },
      { typed + "dimension: 3\nsizes: 2000000000 2000000000 2000000000\n\n",
        "than can be counted" },
      { typed + "dimension: 3\nsizes: 300000 400000 50000\n\n" + bytes,
        "6000000000000000 bytes, but there are only 60" },
      { typed + "dimension: 4\nsizes: 2 2 3 5\nkinds: domain domain domain list\n\n" + bytes,
        "components is not the first" },
      { typed + "dimension: 5\nsizes: 2 2 3 5 2\n\n" + bytes, "5 axes of space" },
      { typed + Sizes + "kinds: domain domain\n\n" + bytes, "2 words for 3 axes" },
      { typed + Sizes + "space directions: (1,0,0) (0,1,0)\n\n" + bytes, "2 vectors for 3" },
      { typed + Sizes + "space directions: (1,0,0) (0,1,0) (0,0,1\n\n" + bytes,
        "'(0,0,1' in its header is no vector" },
      { typed + Sizes + "space directions: (1,0,0) (0,1,0) (0,x,1)\n\n" + bytes, "'x' is no" },
      { typed + Sizes + "space directions: (1,0,0) (0,1,0) (1,1,0)\n\n" + bytes, "in one plane" },
      { typed + Sizes + "space directions: (1,0,0) (0,1,0) (0,0,0)\n\n" + bytes, "not 0" },
      { typed + Sizes + "space origin: 7\n\n" + bytes, "'7' in its header is no vector" },
      { typed + Sizes + "spacings: 1 0 1\n\n" + bytes, "not 0" },
      { typed + Sizes + "spacings: 1 inf 1\n\n" + bytes, "must be finite" },
      { typed + Sizes + "endian: middle\n\n" + bytes, "'middle', neither little nor big" },
      { typed + Sizes + "byte skip: -2\n\n" + bytes, "'byteskip' of its header is -2" },
      { typed + Sizes + "byte skip: 1\n\n" + bytes, "60 bytes, but there are only 59" },
      { typed + Sizes + "byte skip: 9223372036854775807\n\n" + bytes, "are only 0" },
      { typed + Sizes + "line skip: 9223372036854775807\n\n" + bytes, "are only 0" },
      { typed + Sizes + "line skip: -1\n\n" + bytes, "'lineskip' of its header is -1" },
      { typed + Sizes, "ends in its header" },
      { typed + Sizes + "\n" + bytes.substr(1), "60 bytes, but there are only 59" },
      { typed + Sizes + "data file: none.raw\n", "none.raw' isn't there" },
      { typed + Sizes + "data file: folder.raw\n", "folder.raw' is no regular file" },
      { typed + Sizes + "data file: /dev/zero\n", "/dev/zero' is no regular file" },
      { typed + Sizes + "data file: three.raw\n", "60 bytes, but there are only 3" },
      { typed + Sizes + "data file: three.raw\nbyteskip: -1\n", "but there are only 3" },
      { typed + Sizes + "data file: s%d.raw 1 5 0\n", "in steps of 0, which names no files" },
      { typed + Sizes + "data file: s%d.raw 1 9999999999 1\n", "which names no files" },
      { typed + Sizes + "data file: s%s%n.raw 1 5 1\n", "isn't there" },
      { typed + Sizes + "data file: LIST\n", "is no regular file" },
      { typed + Sizes + "data file: LIST\na\nb\nc\nd\ne\nf\ng\n",
        "7 files, which can't have equal" },
      { raw + "type: block\n" + Sizes + "\n" + bytes, "of the type 'block'" },
      { start + "type: uchar\nencoding: bzip2\n" + Sizes + "\n" + bytes, "encoding 'bzip2'" },
      { start + "type: uchar\nencoding: gzip\n" + Sizes + "\n" + bytes, "values are damaged" },
      { start + "type: uchar\nencoding: gzip\ndimension: 3\nsizes: 300 400 500\n\n" + bytes,
        "60000000 bytes, but there are only 60 encoded ones" },
      { start + "type: uchar\nencoding: gzip\n" + Sizes + "\n" + this->Deflate("xy", true),
        "ends after 2 of 60 bytes" },
      { start + "type: uchar\nencoding: hex\n" + Sizes + "\n" + std::string(120, 'g'),
        "no hexadecimal digits" },
      { start + "type: uchar\nencoding: text\n" + Sizes + "\n1 2 3", "but there are only 5" },
      { start + "type: uchar\nencoding: text\n" + Sizes + "\n1 2 3" + std::string(200, ' '),
        "ends after 3 of 60 values" },
      { start + "type: uchar\nencoding: text\n" + Sizes + "\n256 " + this->Text(),
        "'256', which is no value of unsigned char" },
    })
  {
    this->ExpectError(this->WriteText("a.nrrd", text), words);
  }
}
