// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of nothing but values.
#include "ReaderCase.h"

#include "RawImage.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdint>

namespace
{
using RawImage = ReaderCase;
using tetmarch::RawOptions;

constexpr std::array<int, 3> Dimensions{ { 4, 3, 2 } };

template <typename Value>
std::vector<Value> MakeValues()
{
  std::vector<Value> values;
  for (int i = 0; i < 24; ++i)
  {
    values.push_back(static_cast<Value>(5 * i - (std::is_signed_v<Value> ? 60 : 0)));
  }
  return values;
}

template <typename Value>
std::string BytesOf(std::vector<Value> values, bool bigEndian)
{
  for (Value& value : values)
  {
    char* bytes = reinterpret_cast<char*>(&value);
#ifdef VTK_WORDS_BIGENDIAN
    const bool turned = !bigEndian;
#else
    const bool turned = bigEndian;
#endif
    if (turned)
    {
      std::reverse(bytes, bytes + sizeof(Value));
    }
  }
  return { reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value) };
}
} // namespace

class RawImageOfType : public ReaderCase
{
protected:
  template <typename Value>
  void Check(const std::string& type)
  {
    for (const bool bigEndian : { false, true })
    {
      const std::vector<Value> values = MakeValues<Value>();
      const std::string path = this->WriteText(type + ".raw", BytesOf(values, bigEndian));
      const RawOptions options{ Dimensions, tetmarch::ParseType(type), std::nullopt, bigEndian };
      const auto volume = tetmarch::ReadVolume(path, std::nullopt, options);
      auto* image = vtkImageData::SafeDownCast(volume.Input);
      ASSERT_NE(image, nullptr);
      vtkDataArray* array = image->GetPointData()->GetScalars();
      ASSERT_EQ(array->GetNumberOfTuples(), 24);
      EXPECT_EQ(array->GetDataTypeSize(), int(sizeof(Value)));
      for (int i = 0; i < 24; ++i)
      {
        ASSERT_EQ(array->GetComponent(i, 0), static_cast<double>(values[i])) << type << " " << i;
      }
    }
  }
};

TEST_F(RawImageOfType, IsReadInBothOrdersOfBytes)
{
  this->Check<std::uint8_t>("uint8");
  this->Check<std::int8_t>("int8");
  this->Check<std::uint16_t>("uint16");
  this->Check<std::int16_t>("int16");
  this->Check<std::uint32_t>("uint32");
  this->Check<std::int32_t>("int32");
  this->Check<std::uint64_t>("uint64");
  this->Check<std::int64_t>("int64");
  this->Check<float>("float");
  this->Check<double>("double");
  this->Check<float>("float32");
  this->Check<double>("float64");
}

TEST_F(RawImage, HasTheSpacingThatIsGiven)
{
  const std::string path = this->WriteText("a.raw", std::string(24, 'x'));
  for (const auto& [given, spacing] :
    { std::pair<std::optional<std::array<double, 3>>, std::array<double, 3>>{
        std::nullopt, { { 1.0, 1.0, 1.0 } } },
      { { { 0.5, 1.0, 4.0 } }, { { 0.5, 1.0, 4.0 } } } })
  {
    const RawOptions options{ Dimensions, VTK_UNSIGNED_CHAR, given, false };
    const auto volume = tetmarch::ReadVolume(path, std::nullopt, options);
    auto* image = vtkImageData::SafeDownCast(volume.Input);
    ASSERT_NE(image, nullptr);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(image->GetSpacing()[axis], spacing[axis]);
      EXPECT_EQ(image->GetOrigin()[axis], 0.0);
    }
  }
}

TEST_F(RawImage, MustHaveTheSizeOfItsValues)
{
  const RawOptions options{ Dimensions, VTK_SHORT, std::nullopt, false };
  for (const std::size_t size : { 0, 24, 47, 49 })
  {
    const std::string path = this->WriteText("a.raw", std::string(size, 'x'));
    EXPECT_EQ(GetError(path, std::nullopt, options),
      "cannot read '" + path + "': it has " + std::to_string(size) +
        " bytes, but 4 x 3 x 2 values of int16 are 48; check --dimensions and --type");
  }
  EXPECT_EQ(
    GetError(this->WriteText("a.raw", std::string(48, 'x')), std::nullopt, options), "accepted");
  const RawOptions huge{ { { 65536, 65536, 65536 } }, VTK_DOUBLE, std::nullopt, false };
  EXPECT_NE(GetError(this->GetPath("a.raw"), std::nullopt, huge).find("are 2251799813685248;"),
    std::string::npos);
}

TEST_F(RawImage, MustExist)
{
  const RawOptions options{ Dimensions, VTK_SHORT, std::nullopt, false };
  const std::string path = this->GetPath("none.raw");
  EXPECT_EQ(
    GetError(path, std::nullopt, options), "cannot read '" + path + "': there is no such file");
}

TEST_F(RawImage, OfOneSliceIsNoVolume)
{
  const std::string path = this->WriteText("flat.raw", std::string(12, 'x'));
  const RawOptions options{ { { 4, 3, 1 } }, VTK_UNSIGNED_CHAR, std::nullopt, false };
  EXPECT_EQ(GetError(path, std::nullopt, options),
    "'" + path +
      "' has no 3D cells, so there is no volume to render (vtkImageData of 4 x 3 x 1 points)");
}
