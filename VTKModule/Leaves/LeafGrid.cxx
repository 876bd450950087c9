// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Leaves/LeafGrid.h"

#include "Caching/WithinMemory.h"
#include "Input/DataCheck.h"
#include "Input/TreeCheck.h"
#include "Leaves/LeafList.h"
#include "Scalars/DrawnScalars.h"
#include "Scalars/GhostArrays.h"

#include "vtkAbstractMapper.h"
#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

struct LeafGrid::Input
{
  vtkHyperTreeGrid* Tree = nullptr;
  vtkUniformGridAMR* Levels = nullptr;
  std::vector<Block> Blocks; // of the levels; of a tree one, without data
  Fingerprint Shape;
};

namespace
{

// Positions of planes are floats: integers up to here are exact, and so are their halves.
constexpr int MostPlaces = 1 << 22;

// Of the cells of a tree; nullptr if it has no such array.
vtkDataArray* scalarsOf(vtkHyperTreeGrid* tree, const ScalarSelection& selection)
{
  vtkNew<vtkImageData> standIn;
  standIn->GetCellData()->ShallowCopy(tree->GetCellData());
  int place = 0;
  vtkDataArray* array = vtkAbstractMapper::GetScalars(
    standIn, selection.Mode, selection.AccessMode, selection.Id, selection.Name, place);
  return array && place == 1 && array->GetNumberOfComponents() > 0 ? array : nullptr;
}

// Whether the block has values as the first one has them.
bool isReadable(const Block& block, const Block& first)
{
  auto* image = vtkImageData::SafeDownCast(block.Data);
  return block.Scalars && block.CellScalars &&
         block.Scalars->GetDataType() == first.Scalars->GetDataType() &&
         block.Scalars->GetNumberOfComponents() == first.Scalars->GetNumberOfComponents() &&
         image->GetDirectionMatrix()->IsIdentity() && checkData(image).empty() &&
         checkGhosts(image).empty() && checkScalars(image, block.Scalars, true).empty();
}

int placesOf(const LeafAxis& axis)
{
  return static_cast<int>(axis.Breaks.size() - 1) * axis.CellsBetweenBreaks;
}

bool isEven(const LeafAxis& axis)
{
  const double first = axis.Breaks.front();
  const double length = axis.Breaks.back() - first;
  const auto intervals = static_cast<double>(axis.Breaks.size() - 1);
  bool even = true;
  for (std::size_t i = 1; i < axis.Breaks.size(); ++i)
  {
    const double place = first + length * (static_cast<double>(i) / intervals);
    even = even && std::abs(axis.Breaks[i] - place) <= 1e-12 * length;
  }
  return even;
}

GridGeometry geometryOf(const LeafAxes& axes)
{
  GridGeometry geometry;
  const bool even = std::all_of(axes.begin(), axes.end(), isEven);
  for (int a = 0; a < 3; ++a)
  {
    const int places = placesOf(axes[a]);
    geometry.Points[a] = places + 1;
    geometry.Origin[a] = axes[a].Breaks.front();
    geometry.Steps[a][a] = (axes[a].Breaks.back() - axes[a].Breaks.front()) / places;
    for (int i = 0; !even && i <= places; ++i)
    {
      geometry.Coordinates[a].push_back(axes[a].position(i));
    }
  }
  return geometry;
}

// False if they don't make an octree.
bool placeLeaves(const std::vector<Leaf>& leaves, LeafPlaces& places)
{
  const std::array<int, 3>& points = places.Geometry.Points;
  const std::array<int, 3> count{ { points[0] - 1, points[1] - 1, points[2] - 1 } };
  places.Count = leaves.size();
  OctreeBuilder builder(count, leaves.size(), static_cast<std::uint32_t>(leaves.size()));
  double filled = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const LeafPlace& size = leaves[i].Size;
    if (size[0] != size[1] || size[0] != size[2] ||
        !builder.add({ leaves[i].Low, size[0] }, static_cast<std::uint32_t>(i)))
    {
      return false;
    }
    filled += double(size[0]) * size[1] * size[2];
  }
  places.Fill = filled == double(count[0]) * count[1] * count[2];
  places.Tree = builder.take();
  return true;
}

// Of an image with at least this many cells.
std::array<int, 3> sidesFor(std::size_t cells)
{
  constexpr std::size_t row = std::size_t(1) << OctreeRowShift;
  const std::size_t rows = (cells + row - 1) / row;
  return { { static_cast<int>(std::min(cells, row)), static_cast<int>(std::min(rows, row)),
    static_cast<int>((rows + row - 1) / row) } };
}

} // namespace

void LeafGrid::clear()
{
  const StageRecord record = this->Record;
  *this = {};
  this->Record = record;
}

bool LeafGrid::readInput(vtkDataObject* data, const ScalarSelection& selection, Input& input)
{
  input.Tree = vtkHyperTreeGrid::SafeDownCast(data);
  input.Levels = vtkUniformGridAMR::SafeDownCast(data);
  if (vtkHyperTreeGrid* tree = input.Tree)
  {
    if (tree->GetBranchFactor() != 2 || !checkTree(tree).empty())
    {
      return false;
    }
    input.Blocks.push_back({ nullptr, 1, {}, scalarsOf(tree, selection), true });
    add(input.Shape, tree);
    for (vtkObject* part : std::initializer_list<vtkObject*>{ tree->GetXCoordinates(),
           tree->GetYCoordinates(), tree->GetZCoordinates(),
           tree->HasMask() ? tree->GetMask() : nullptr, tree->GetGhostCells() })
    {
      add(input.Shape, part);
    }
    return input.Blocks.front().Scalars != nullptr;
  }
  if (!input.Levels)
  {
    return false;
  }
  input.Blocks = listBlocks(input.Levels, selection);
  std::vector<Block>& blocks = input.Blocks;
  blocks.erase(
    std::remove_if(blocks.begin(), blocks.end(), [](const Block& b) { return !hasLeaves(b); }),
    blocks.end());
  input.Shape = shapeOf(blocks);
  return !blocks.empty() && blocks.front().Scalars;
}

void LeafGrid::place(const Input& input)
{
  const std::vector<Block>& blocks = input.Blocks;
  if (input.Levels && !std::all_of(blocks.begin(), blocks.end(),
                        [&](const Block& block) { return isReadable(block, blocks.front()); }))
  {
    return;
  }
  LeafList list;
  LeafAxes axes;
  const std::string error = input.Tree ? listLeaves(input.Tree, list, axes)
                                       : listLeaves(input.Levels, input.Blocks, list, axes);
  if (!error.empty() || list.shown().empty() ||
      std::any_of(
        axes.begin(), axes.end(), [](const LeafAxis& axis) { return placesOf(axis) > MostPlaces; }))
  {
    return;
  }
  const auto places = std::make_shared<LeafPlaces>();
  places->Geometry = geometryOf(axes);
  if (!placeLeaves(list.shown(), *places))
  {
    return;
  }
  std::vector<vtkIdType> begins{ 0 };
  this->Origins = {};
  for (const Block& block : blocks)
  {
    const vtkIdType count = block.Scalars->GetNumberOfTuples();
    begins.push_back(begins.back() + count);
    input.Levels ? this->Origins.add(block.FlatIndex, count) : void();
  }
  this->Tuples.clear();
  this->Tuples.reserve(list.origins().size());
  for (const LeafList::Origin& origin : list.origins())
  {
    this->Tuples.push_back(begins[origin.Source] + origin.Tuple);
  }
  input.Levels ? this->Origins.renumber(std::vector<vtkIdType>(this->Tuples)) : void();
  this->Places = places;
}

// The leaves of each source follow each other.
void LeafGrid::gather(const Input& input)
{
  vtkDataArray* first = input.Blocks.front().Scalars;
  const std::size_t needed = this->Places->Count + (this->Places->Fill ? 0 : 1);
  const std::array<int, 3> sides = sidesFor(needed);
  const vtkIdType cells = vtkIdType(sides[0]) * sides[1] * sides[2];
  const auto values = vtk::TakeSmartPointer(first->NewInstance());
  values->SetName(first->GetName());
  values->SetNumberOfComponents(first->GetNumberOfComponents());
  values->SetNumberOfTuples(cells);
  std::size_t source = 0;
  vtkIdType begin = 0;
  const auto last = static_cast<vtkIdType>(this->Places->Count) - 1;
  for (vtkIdType i = 0; i <= last; ++i)
  {
    while (this->Tuples[i] >= begin + input.Blocks[source].Scalars->GetNumberOfTuples())
    {
      begin += input.Blocks[source++].Scalars->GetNumberOfTuples();
    }
    values->SetTuple(i, this->Tuples[i] - begin, input.Blocks[source].Scalars);
  }
  for (vtkIdType i = last + 1; i < cells; ++i)
  {
    values->SetTuple(i, last, values);
  }
  this->Values = vtkSmartPointer<vtkImageData>::New();
  this->Values->SetDimensions(sides[0] + 1, sides[1] + 1, sides[2] + 1);
  this->Values->GetCellData()->SetScalars(values);
  if (!this->Places->Fill)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(cells);
    ghosts->FillValue(0);
    ghosts->SetValue(last + 1, vtkDataSetAttributes::HIDDENCELL);
    this->Values->GetCellData()->AddArray(ghosts);
  }
}

void LeafGrid::make(const Input& input)
{
  Fingerprint valuesFrom = input.Shape;
  for (const Block& block : input.Blocks)
  {
    add(valuesFrom, block.Scalars);
  }
  if (valuesFrom == this->ValuesFrom)
  {
    return;
  }
  const StageRecorder recorder(this->Record);
  // Other arrays may be unsound, or of other types.
  if (input.Levels || !this->Places || input.Shape != this->Shape)
  {
    this->Places = nullptr;
    this->Values = nullptr;
    this->place(input);
  }
  if (this->Places)
  {
    this->gather(input);
  }
  this->Shape = input.Shape;
  this->ValuesFrom = valuesFrom;
}

bool LeafGrid::update(vtkDataObject* data, const ScalarSelection& selection)
{
  bool read = false;
  const std::string shortage = withinMemory("the leaves",
    [&]
    {
      Input input;
      read = readInput(data, selection, input);
      read ? this->make(input) : void();
    });
  if (!read || !shortage.empty())
  {
    this->clear();
  }
  return this->Places != nullptr;
}

vtkImageData* LeafGrid::values() const { return this->Values; }

vtkDataArray* LeafGrid::scalars() const
{
  return this->Values ? this->Values->GetCellData()->GetScalars() : nullptr;
}

} // namespace tetmarch
