// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Image files of given bytes, what is read of them, and what vtkMetaImageReader or
 *        vtkNrrdReader reads
 */
#ifndef tetmarch_testing_ImageFileCase_h
#define tetmarch_testing_ImageFileCase_h

#include "ReaderCase.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtk_zlib.h"

#include <array>
#include <string>
#include <vector>

class ImageFileCase : public ReaderCase
{
protected:
  static constexpr int NumberOfValues = 3 * 4 * 5;

  static double ValueAt(int i) { return 2 * i + 1; }

  template <typename Value>
  static std::string Bytes(bool bigEndian = false)
  {
    std::string bytes;
    for (int i = 0; i < NumberOfValues; ++i)
    {
      auto value = static_cast<Value>(ValueAt(i));
      bigEndian ? vtkByteSwap::SwapBE(&value) : vtkByteSwap::SwapLE(&value);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    return bytes;
  }

  static std::string Text()
  {
    std::string text;
    for (int i = 0; i < NumberOfValues; ++i)
    {
      text += std::to_string(static_cast<int>(ValueAt(i))) + (i % 7 == 6 ? "\n" : " ");
    }
    return text;
  }

  static std::string Hex(const std::string& bytes)
  {
    std::string text;
    for (const char c : bytes)
    {
      const auto byte = static_cast<unsigned char>(c);
      text += "0123456789abcdef"[byte / 16];
      text += "0123456789ABCDEF"[byte % 16];
      text += text.size() % 24 == 0 ? "\n" : "";
    }
    return text;
  }

  /// As a file of gzip, or a stream of zlib.
  static std::string Deflate(const std::string& bytes, bool gzip)
  {
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS + (gzip ? 16 : 0), 8, 0), Z_OK);
    std::string text(bytes.size() + 100, ' ');
    stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<unsigned>(bytes.size());
    stream.next_out = reinterpret_cast<unsigned char*>(text.data());
    stream.avail_out = static_cast<unsigned>(text.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    text.resize(stream.total_out);
    deflateEnd(&stream);
    return text;
  }

  static vtkSmartPointer<vtkImageData> Read(const std::string& path)
  {
    try
    {
      return vtkImageData::SafeDownCast(tetmarch::ReadVolume(path, std::nullopt).Input);
    }
    catch (const tetmarch::Failure& failure)
    {
      ADD_FAILURE() << failure.what();
      return nullptr;
    }
  }

  /// All values, in the order of the file.
  static void ExpectValues(vtkImageData* image, int type, const std::string& what)
  {
    ASSERT_NE(image, nullptr) << what;
    vtkDataArray* array = image->GetPointData()->GetScalars();
    ASSERT_EQ(array->GetDataType(), type) << what;
    ASSERT_EQ(array->GetNumberOfValues(), NumberOfValues) << what;
    for (int i = 0; i < NumberOfValues; ++i)
    {
      const int n = array->GetNumberOfComponents();
      ASSERT_EQ(array->GetComponent(i / n, i % n), ValueAt(i)) << what << ", value " << i;
    }
  }

  /// The same values and geometry, but for the directions that VTK's reader leaves out.
  template <typename VTKReader>
  static void ExpectWhatVTKReads(const std::string& path)
  {
    vtkNew<VTKReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkImageData* other = reader->GetOutput();
    const auto image = Read(path);
    ASSERT_NE(image, nullptr) << path;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(image->GetDimensions()[axis], other->GetDimensions()[axis]) << path;
      EXPECT_EQ(image->GetSpacing()[axis], other->GetSpacing()[axis]) << path;
      EXPECT_EQ(image->GetOrigin()[axis], other->GetOrigin()[axis]) << path;
    }
    vtkDataArray* values = image->GetPointData()->GetScalars();
    vtkDataArray* otherValues = other->GetPointData()->GetScalars();
    EXPECT_STREQ(values->GetName(), otherValues->GetName()) << path;
    ASSERT_EQ(values->GetNumberOfComponents(), otherValues->GetNumberOfComponents()) << path;
    ASSERT_EQ(values->GetNumberOfTuples(), otherValues->GetNumberOfTuples()) << path;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < values->GetNumberOfComponents(); ++k)
      {
        ASSERT_EQ(values->GetComponent(i, k), otherValues->GetComponent(i, k)) << path;
      }
    }
  }

  static void ExpectGeometry(vtkImageData* image, const std::array<double, 3>& spacing,
    const std::array<double, 3>& origin, const std::array<double, 9>& direction,
    const std::string& what)
  {
    ASSERT_NE(image, nullptr) << what;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_DOUBLE_EQ(image->GetSpacing()[k], spacing[k]) << what << ", spacing " << k;
      EXPECT_DOUBLE_EQ(image->GetOrigin()[k], origin[k]) << what << ", origin " << k;
    }
    for (int k = 0; k < 9; ++k)
    {
      EXPECT_DOUBLE_EQ(image->GetDirectionMatrix()->GetData()[k], direction[k])
        << what << ", " << k;
    }
  }

  void ExpectError(const std::string& path, const std::string& words) const
  {
    ::testing::internal::CaptureStderr();
    const std::string error = GetError(path);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << path;
    EXPECT_EQ(error.find("cannot read '" + path + "': "), 0u) << error;
    EXPECT_NE(error.find(words), std::string::npos) << error << " instead of " << words;
  }
};

#endif
