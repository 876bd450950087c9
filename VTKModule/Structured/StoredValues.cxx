// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/StoredValues.h"

#include "Parallel/ParallelFor.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkSMPThreadLocal.h"

#include <atomic>
#include <cmath>

namespace tetmarch
{
namespace
{

// The largest value of a borrowed array, in widths of its range. Scale u + Offset is then accurate
// to 7e-7: u, its product and the offset are at most that, and each is rounded to 2^-24 of it.
constexpr double MostWidths = 4;

// Calls work(tuples, first, last) for parts of all tuples; tuples[i] is a tuple.
template <typename Work>
struct TupleVisitor
{
  const Work& Do;

  template <typename Array>
  void operator()(Array* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    parallelFor(
      0, tuples.size(), [&](vtkIdType first, vtkIdType last) { this->Do(tuples, first, last); });
  }
};

template <typename Work>
void visitTuples(vtkDataArray* array, const Work& work)
{
  TupleVisitor<Work> visitor{ work };
  if (!vtkArrayDispatch::Dispatch::Execute(array, visitor))
  {
    // An array that computes its values may not be thread-safe.
    work(vtk::DataArrayTupleRange(array), vtkIdType(0), array->GetNumberOfTuples());
  }
}

template <typename Value>
ScalarRange rangeOfIntegers(const Value* values, std::size_t count)
{
  vtkSMPThreadLocal<FiniteRange> ranges;
  parallelFor(0, static_cast<vtkIdType>(count),
    [&](vtkIdType first, vtkIdType last)
    {
      Value low = values[first];
      Value high = low;
      for (vtkIdType i = first; i < last; ++i)
      {
        low = values[i] < low ? values[i] : low;
        high = values[i] > high ? values[i] : high;
      }
      ranges.Local().add(low);
      ranges.Local().add(high);
    });
  FiniteRange all;
  for (const FiniteRange& range : ranges)
  {
    all.add(range);
  }
  return all.range();
}

ScalarRange rangeOf(vtkDataArray* array, const TupleScalar& scalar)
{
  vtkSMPThreadLocal<FiniteRange> ranges;
  visitTuples(array,
    [&](const auto& tuples, vtkIdType first, vtkIdType last)
    {
      FiniteRange range;
      for (vtkIdType i = first; i < last; ++i)
      {
        range.add(scalarOf(tuples[i], scalar));
      }
      ranges.Local().add(range);
    });
  FiniteRange all;
  for (const FiniteRange& range : ranges)
  {
    all.add(range);
  }
  return all.range();
}

ValueType typeOf(vtkDataArray* array, const TupleScalar& scalar)
{
  if (scalar.Magnitude)
  {
    return ValueType::Float32;
  }
  switch (array->GetDataType())
  {
    case VTK_BIT:
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
      return ValueType::UInt8;
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return ValueType::UInt16;
    default:
      return ValueType::Float32;
  }
}

// Whether the array consists of contiguous unsigned integers of 8 or 16 bits.
bool liesAsStored(vtkDataArray* array)
{
  const int type = array->GetDataType();
  return (type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT) &&
         array->GetNumberOfComponents() == 1 && array->HasStandardMemoryLayout();
}

double greatestOf(ValueType type) { return type == ValueType::UInt8 ? 255 : 65535; }

void setScale(StoredValues& values, double valueOfZero)
{
  values.Scale = static_cast<float>(greatestOf(values.Type) / values.Range.width());
  values.Offset = static_cast<float>((valueOfZero - values.Range.Low) / values.Range.width());
}

ScalarRange rangeOfStored(vtkDataArray* array, const StoredValues& values)
{
  const void* data = array->GetVoidPointer(0);
  return values.Type == ValueType::UInt8
           ? rangeOfIntegers(static_cast<const std::uint8_t*>(data), values.Count)
           : rangeOfIntegers(static_cast<const std::uint16_t*>(data), values.Count);
}

// Stores the difference to the minimum of the range, which fits into the type.
template <typename Value>
void copyIntegers(
  vtkDataArray* array, const TupleScalar& scalar, StoredValues& values, std::vector<Value>& copied)
{
  copied.resize(values.Count);
  values.Data = copied.data();
  setScale(values, values.Range.Low);
  visitTuples(array,
    [&](const auto& tuples, vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        copied[i] = static_cast<Value>(scalarOf(tuples[i], scalar) - values.Range.Low);
      }
    });
}

void copyFloats(vtkDataArray* array, const TupleScalar& scalar, StoredValues& values)
{
  values.Floats.resize(values.Count);
  values.Data = values.Floats.data();
  visitTuples(array,
    [&](const auto& tuples, vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        values.Floats[i] = storedScalar(scalarOf(tuples[i], scalar), values.Range);
      }
    });
}

void copy(vtkDataArray* array, const TupleScalar& scalar, StoredValues& values)
{
  switch (values.Type)
  {
    case ValueType::UInt8:
      return copyIntegers(array, scalar, values, values.Bytes);
    case ValueType::UInt16:
      return copyIntegers(array, scalar, values, values.Words);
    default:
      return copyFloats(array, scalar, values);
  }
}

StoredValues start(vtkDataArray* array, ValueType type)
{
  StoredValues values;
  values.Type = type;
  values.Count = static_cast<std::size_t>(array->GetNumberOfTuples());
  return values;
}

StoredValues store(vtkDataArray* array, const TupleScalar& scalar)
{
  StoredValues values = start(array, typeOf(array, scalar));
  const bool lies = values.Type != ValueType::Float32 && liesAsStored(array);
  values.Range = lies ? rangeOfStored(array, values) : rangeOf(array, scalar);
  if (lies && values.Range.High <= MostWidths * values.Range.width())
  {
    values.Borrowed = array;
    values.Data = array->GetVoidPointer(0);
    setScale(values, 0);
  }
  else
  {
    copy(array, scalar, values);
  }
  return values;
}

// Divided by the unit and clamped to 0..1; bytes need no clamping.
StoredValues storeByUnit(vtkDataArray* array, const TupleScalar& scalar, double unit)
{
  const bool bytes = array->GetDataType() == VTK_UNSIGNED_CHAR && unit >= 255;
  StoredValues values = start(array, bytes ? ValueType::UInt8 : ValueType::Float32);
  values.Range = { 0, unit };
  copy(array, scalar, values);
  return values;
}

// A tuple with a value that is not finite is not drawn: its first value becomes UndrawnScalar.
void hideUndrawn(StoredValues& extra, StoredValues& first)
{
  std::atomic<bool> any{ false };
  parallelFor(0, static_cast<vtkIdType>(extra.Floats.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (extra.Floats[i] == UndrawnScalar)
        {
          extra.Floats[i] = 0;
          first.Floats[i] = UndrawnScalar;
          any = true;
        }
      }
    });
  first.Range.AllFinite = first.Range.AllFinite && !any;
}

} // namespace

std::vector<StoredValues> storeValues(const DrawnScalars& drawn)
{
  std::vector<StoredValues> all;
  all.reserve(1 + drawn.Extra.size());
  all.push_back(store(drawn.Array, drawn.First));
  for (const int component : drawn.Extra)
  {
    const TupleScalar scalar{ false, component };
    all.push_back(drawn.ExtraUnit > 0 ? storeByUnit(drawn.Array, scalar, drawn.ExtraUnit)
                                      : store(drawn.Array, scalar));
    // Only floating-point arrays have such values, and all of their components are Floats.
    hideUndrawn(all.back(), all.front());
  }
  return all;
}

} // namespace tetmarch
