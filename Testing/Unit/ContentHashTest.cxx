// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays have the same hash if and only if their values are the same.
#include "Caching/ContentHash.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace
{
using namespace tetmarch;

template <typename Array>
vtkSmartPointer<Array> ramp(vtkIdType tuples, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, static_cast<double>((i * components + c) % 251));
    }
  }
  return array;
}

TEST(ContentHash, OfCopiesIsTheSame)
{
  for (const vtkIdType size : { 0, 1, 3, 4, 5, 1000, 70000, 3000000 })
  {
    const auto array = ramp<vtkFloatArray>(size);
    vtkNew<vtkFloatArray> copy;
    copy->DeepCopy(array);
    EXPECT_EQ(contentHashOf(copy), contentHashOf(array));
  }
  EXPECT_EQ(contentHashOf(nullptr), ContentHash());
}

TEST(ContentHash, DiffersByEachBit)
{
  // Up to a stripe beyond one of the pieces that are hashed in parallel.
  for (const vtkIdType size : { 1, 31, 32, 33, 100, 65537, 65600 })
  {
    const auto array = ramp<vtkUnsignedCharArray>(size);
    std::set<ContentHash> hashes{ contentHashOf(array) };
    std::size_t changes = 0;
    for (vtkIdType i = 0; i < size; i += size < 200 || i > size - 40 ? 1 : 997)
    {
      const unsigned char value = array->GetValue(i);
      for (int bit = 0; bit < 8; ++bit)
      {
        array->SetValue(i, static_cast<unsigned char>(value ^ 1 << bit));
        hashes.insert(contentHashOf(array));
        ++changes;
      }
      array->SetValue(i, value);
    }
    EXPECT_EQ(hashes.size(), changes + 1);
    std::set<std::uint64_t> words;
    for (const ContentHash& hash : hashes)
    {
      words.insert(hash.begin(), hash.end());
    }
    EXPECT_EQ(words.size(), 2 * hashes.size()) << "the two are not independent";
  }
}

TEST(ContentHash, DiffersByTheOrder)
{
  const auto array = ramp<vtkDoubleArray>(200);
  std::set<ContentHash> hashes{ contentHashOf(array) };
  std::size_t swaps = 0;
  for (vtkIdType i = 0; i < 200; ++i)
  {
    for (vtkIdType j = 0; j < i; ++j)
    {
      const double a = array->GetValue(i);
      const double b = array->GetValue(j);
      array->SetValue(i, b);
      array->SetValue(j, a);
      hashes.insert(contentHashOf(array));
      array->SetValue(i, a);
      array->SetValue(j, b);
      ++swaps;
    }
  }
  EXPECT_EQ(hashes.size(), swaps + 1);
}

TEST(ContentHash, DiffersByLengthTypeAndComponents)
{
  std::set<ContentHash> hashes;
  std::size_t arrays = 0;
  for (vtkIdType size = 0; size < 70; ++size, ++arrays)
  {
    vtkNew<vtkDoubleArray> zeros;
    zeros->SetNumberOfTuples(size);
    zeros->Fill(0.0);
    hashes.insert(contentHashOf(zeros));
  }
  EXPECT_EQ(hashes.size(), arrays);
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkIntArray> ints;
  floats->SetNumberOfTuples(12);
  ints->SetNumberOfTuples(12);
  floats->Fill(0);
  ints->Fill(0);
  EXPECT_NE(contentHashOf(floats), contentHashOf(ints));
  EXPECT_NE(contentHashOf(ramp<vtkIntArray>(12, 1)), contentHashOf(ramp<vtkIntArray>(4, 3)));
}

TEST(ContentHash, ComparesBits)
{
  const auto array = ramp<vtkDoubleArray>(9);
  array->SetValue(4, std::numeric_limits<double>::quiet_NaN());
  vtkNew<vtkDoubleArray> copy;
  copy->DeepCopy(array);
  EXPECT_EQ(contentHashOf(copy), contentHashOf(array));
  array->SetValue(0, -0.0);
  EXPECT_NE(contentHashOf(copy), contentHashOf(array));
  copy->SetValue(0, -0.0);
  EXPECT_EQ(contentHashOf(copy), contentHashOf(array));
  copy->SetValue(8, std::nextafter(8.0, 9.0));
  EXPECT_NE(contentHashOf(copy), contentHashOf(array));
}

TEST(ContentHash, OfArraysThatDoNotLieInOrder)
{
  const auto array = ramp<vtkSOADataArrayTemplate<double>>(1000, 3);
  const auto copy = ramp<vtkSOADataArrayTemplate<double>>(1000, 3);
  EXPECT_EQ(contentHashOf(copy), contentHashOf(array));
  copy->SetComponent(999, 2, -1.0);
  EXPECT_NE(contentHashOf(copy), contentHashOf(array));
}

TEST(ContentHash, TheSameWithAnyNumberOfThreads)
{
  const auto array = ramp<vtkIntArray>(1000003);
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const ContentHash hash = contentHashOf(array);
  vtkSMPTools::SetBackend("STDThread");
  for (const int count : { 1, 2, 3, 8 })
  {
    vtkSMPTools::Initialize(count);
    EXPECT_EQ(contentHashOf(array), hash);
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(before.c_str());
}
} // namespace
