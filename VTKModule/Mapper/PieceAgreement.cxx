// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/PieceAgreement.h"

#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>
#include <limits>

namespace tetmarch
{
namespace
{

using Stream = vtkMultiProcessStream;

/** The corners of a box; the lowest is above the highest if it is empty. */
struct Corners
{
  Vector3 Low;
  Vector3 High;
  Corners()
  {
    this->Low.fill(std::numeric_limits<double>::max());
    this->High.fill(std::numeric_limits<double>::lowest());
  }
  bool isEmpty() const { return this->Low[0] > this->High[0]; }
  void add(const Vector3& point)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Low[k] = std::min(this->Low[k], point[k]);
      this->High[k] = std::max(this->High[k], point[k]);
    }
  }
};

// Of the points that cells use.
Corners cornersOf(vtkUnstructuredGrid* grid)
{
  Corners corners;
  if (!grid || !grid->GetPoints() || grid->GetNumberOfCells() == 0)
  {
    return corners;
  }
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkDataArray* connectivity = grid->GetCells()->GetConnectivityArray();
  for (const auto point : vtk::DataArrayValueRange<1>(connectivity))
  {
    const auto id = static_cast<vtkIdType>(point);
    if (id >= 0 && id < points) // else GridCheck has words for it
    {
      Vector3 position;
      grid->GetPoint(id, position.data());
      corners.add(position);
    }
  }
  return corners;
}

bool isInFloat(vtkUnstructuredGrid* grid)
{
  return grid && grid->GetPoints() && grid->GetNumberOfCells() > 0 &&
         grid->GetPoints()->GetDataType() != VTK_DOUBLE;
}

template <typename T>
std::string bytesOf(const T& value)
{
  static_assert(std::is_trivially_copyable<T>::value, "its bytes are sent");
  return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename T>
void setBytes(const std::string& bytes, T& value)
{
  std::memcpy(&value, bytes.data(), std::min(bytes.size(), sizeof(value)));
}

std::string named(const Group& group, int process, const std::string& error)
{
  return group.size() > 1 ? "Process " + std::to_string(process) + ": " + error : error;
}

} // namespace

vtkBoundingBox wholeBox(Group& group, const vtkBoundingBox& own)
{
  std::array<double, 6> bounds;
  own.GetBounds(bounds.data());
  Stream message;
  for (const double bound : bounds)
  {
    message << bound;
  }
  vtkBoundingBox whole;
  for (Stream& said : group.tellAll(message))
  {
    for (double& bound : bounds)
    {
      said >> bound;
    }
    const vtkBoundingBox box(bounds.data());
    if (box.IsValid())
    {
      whole.AddBox(box);
    }
  }
  return whole;
}

std::string agreeOnWhole(
  Group& group, const std::string& own, vtkUnstructuredGrid* grid, WholeVolume& whole)
{
  const Corners piece = cornersOf(grid);
  Stream message;
  const bool byCoordinates = whole.Piece.ByCoordinates && !piece.isEmpty();
  message << own << isInFloat(grid) << byCoordinates << bytesOf(whole.Level)
          << whole.SampleDistance;
  for (int k = 0; k < 3; ++k)
  {
    message << piece.Low[k] << piece.High[k];
  }
  std::vector<Stream> said = group.tellAll(message);
  std::string wrong;
  Corners all;
  whole.Piece = {};
  for (int p = 0; p < group.size(); ++p)
  {
    std::string error, level;
    bool inFloat = false, cutsByCoordinates = false;
    double distance = 1;
    said[p] >> error >> inFloat >> cutsByCoordinates >> level >> distance;
    wrong = wrong.empty() && !error.empty() ? named(group, p, error) : wrong;
    whole.Piece.InFloat = whole.Piece.InFloat || inFloat;
    whole.Piece.ByCoordinates = whole.Piece.ByCoordinates || cutsByCoordinates;
    if (p == 0)
    {
      setBytes(level, whole.Level);
      whole.SampleDistance = distance;
    }
    Corners other;
    for (int k = 0; k < 3; ++k)
    {
      said[p] >> other.Low[k] >> other.High[k];
    }
    if (!other.isEmpty())
    {
      all.add(other.Low);
      all.add(other.High);
    }
  }
  whole.IsEmpty = all.isEmpty();
  if (!whole.IsEmpty)
  {
    whole.Box =
      vtkBoundingBox(all.Low[0], all.High[0], all.Low[1], all.High[1], all.Low[2], all.High[2]);
  }
  whole.Piece.IsPiece = group.size() > 1;
  return !wrong.empty() || whole.IsEmpty || !whole.Piece.IsPiece
           ? wrong
           : findFrame(all.Low, all.High, whole.Piece.Frame);
}

PartStatus agreeOnScalars(Group& group, const PartStatus& own, bool hasPiece,
  const std::vector<FiniteRange>& ranges, DrawnScalars& drawn)
{
  Stream message;
  message << own.Error << own.Stopped << hasPiece << drawn.OfCells << static_cast<int>(drawn.Mix)
          << static_cast<int>(ranges.size());
  for (const FiniteRange& range : ranges)
  {
    message << range.low() << range.high() << range.isAllFinite();
  }
  std::vector<Stream> said = group.tellAll(message);
  PartStatus all;
  int first = -1; // process that has a piece
  drawn.Whole.clear();
  for (int p = 0; p < group.size(); ++p)
  {
    PartStatus part;
    bool draws = false, ofCells = false;
    int mix = 0, count = 0;
    said[p] >> part.Error >> part.Stopped >> draws >> ofCells >> mix >> count;
    all.Error = all.Error.empty() && !part.Error.empty() ? named(group, p, part.Error) : all.Error;
    all.Stopped = all.Stopped || part.Stopped;
    if (!draws)
    {
      continue;
    }
    if (first < 0)
    {
      first = p;
      drawn.Whole.resize(count);
      drawn.OfCells = hasPiece ? drawn.OfCells : ofCells;
      drawn.Mix = hasPiece ? drawn.Mix : static_cast<ComponentMix>(mix);
    }
    if (all.Error.empty() &&
        (ofCells != drawn.OfCells || static_cast<ComponentMix>(mix) != drawn.Mix ||
          static_cast<std::size_t>(count) != drawn.Whole.size()))
    {
      all.Error = "The processes draw a volume together, but their scalars are of different kinds: "
                  "those of process " +
                  std::to_string(p) + " are not of points or cells as those of process " +
                  std::to_string(first) + " are, or have another number of components.";
    }
    for (int k = 0; k < count; ++k)
    {
      double low = 0, high = 0;
      bool finite = true;
      said[p] >> low >> high >> finite;
      if (static_cast<std::size_t>(k) < drawn.Whole.size())
      {
        drawn.Whole[k].add(FiniteRange(low, high, finite));
      }
    }
  }
  return all;
}

std::string agreeOnNothingVisible(Group& group, bool hasPiece, const std::string& own)
{
  Stream message;
  message << hasPiece << own;
  std::string why;
  bool mayBeVisible = false;
  for (Stream& said : group.tellAll(message))
  {
    bool has = false;
    std::string other;
    said >> has >> other;
    mayBeVisible = mayBeVisible || (has && other.empty());
    why = why.empty() ? other : why;
  }
  return mayBeVisible ? std::string() : why;
}

} // namespace tetmarch
