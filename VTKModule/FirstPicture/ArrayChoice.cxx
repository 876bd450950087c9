// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/ArrayChoice.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace tetmarch
{

namespace
{

// The last word of a name, in lower case: "ids" of "vtkOriginalCellIds", "id" of "block_id".
std::string lastWordOf(const std::string& name)
{
  std::string word;
  for (std::size_t i = name.size(); i-- > 0;)
  {
    const auto letter = static_cast<unsigned char>(name[i]);
    if (!std::isalpha(letter))
    {
      if (word.empty())
      {
        continue; // digits at the end
      }
      break;
    }
    word.insert(word.begin(), static_cast<char>(std::tolower(letter)));
    const bool begins =
      std::isupper(letter) && (i == 0 || !std::isupper(static_cast<unsigned char>(name[i - 1])));
    if (begins)
    {
      break;
    }
  }
  return word;
}

vtkDataSetAttributes* attributesOf(vtkDataSet* block, bool ofCells)
{
  return ofCells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData();
}

// An array in all blocks that have it, with the same number of components.
std::vector<vtkDataArray*> partsOf(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  std::vector<vtkDataArray*> parts;
  for (vtkDataSet* block : blocks)
  {
    vtkDataArray* part = attributesOf(block, drawn.OfCells)->GetArray(drawn.Array->GetName());
    if (part && part->GetNumberOfComponents() == drawn.Array->GetNumberOfComponents())
    {
      parts.push_back(part);
    }
  }
  return parts;
}

bool isFloating(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

// Whether it is the scalars of all blocks.
bool isActive(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  return std::all_of(blocks.begin(), blocks.end(),
    [&drawn](vtkDataSet* block)
    {
      vtkDataSetAttributes* attributes = attributesOf(block, drawn.OfCells);
      vtkDataArray* array = attributes->GetArray(drawn.Array->GetName());
      return array && array == attributes->GetScalars();
    });
}

vtkIdType countTuples(const std::vector<vtkDataArray*>& parts)
{
  vtkIdType count = 0;
  for (vtkDataArray* part : parts)
  {
    count += part->GetNumberOfTuples();
  }
  return count;
}

// Whether all finite values of the first component are integers; share: the fraction of distinct
// values among the sampled ones.
bool isWhole(const std::vector<vtkDataArray*>& parts, double& share)
{
  constexpr vtkIdType most = 1 << 16;
  const vtkIdType step = std::max<vtkIdType>(1, countTuples(parts) / most);
  std::set<double> different;
  vtkIdType seen = 0;
  for (vtkDataArray* part : parts)
  {
    for (vtkIdType i = 0; i < part->GetNumberOfTuples(); i += step, ++seen)
    {
      const double value = part->GetComponent(i, 0);
      if (std::isfinite(value) && value != std::floor(value))
      {
        return false;
      }
      different.insert(std::isfinite(value) ? value : std::numeric_limits<double>::max());
    }
  }
  share = seen > 0 ? double(different.size()) / double(seen) : 0;
  return true;
}

ArrayKind kindOf(
  const std::vector<vtkDataArray*>& parts, const std::optional<std::array<double, 2>>& range)
{
  if (!range)
  {
    return ArrayKind::NotFinite;
  }
  if (!((*range)[0] < (*range)[1]))
  {
    return ArrayKind::Constant;
  }
  constexpr double nearlyAll = 0.9;
  constexpr vtkIdType few = 64; // all of them may differ by chance
  double share = 0;
  const bool numbers =
    parts[0]->GetNumberOfComponents() == 1 && isWhole(parts, share) &&
    (namesNumbers(parts[0]->GetName()) || (share > nearlyAll && countTuples(parts) > few));
  return numbers ? ArrayKind::Numbers : ArrayKind::Physical;
}

// Smaller is better.
std::tuple<bool, int, bool, bool, bool, bool> rankOf(const FoundArray& found)
{
  return { !found.Everywhere, static_cast<int>(found.Kind), found.Drawn.OfCells, !found.Floating,
    found.Drawn.Array->GetNumberOfComponents() > 1, !found.Active };
}

std::string listOf(const std::vector<FoundArray>& all)
{
  std::string text;
  for (const bool ofCells : { false, true })
  {
    std::string names;
    for (const FoundArray& found : all)
    {
      if (found.Drawn.OfCells == ofCells)
      {
        names += (names.empty() ? "" : ", ") + std::string(found.Drawn.Array->GetName());
      }
    }
    text +=
      std::string(ofCells ? "; on cells: " : "on points: ") + (names.empty() ? "none" : names);
  }
  return text;
}

// All arrays of an association in all blocks; of arrays with the same name the first.
std::vector<DrawnArray> namedArrays(const std::vector<vtkDataSet*>& blocks, bool ofCells)
{
  std::vector<DrawnArray> all;
  std::set<std::string> names{ "vtkGhostType", "vtkValidPointMask" };
  for (vtkDataSet* block : blocks)
  {
    vtkDataSetAttributes* attributes =
      ofCells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() && names.insert(array->GetName()).second)
      {
        all.push_back({ array, ofCells, array->GetNumberOfComponents() > 1 ? -1 : 0 });
      }
    }
  }
  return all;
}

// The reason why the requested array was not found; empty if there is no such array.
std::string describeMisfit(const std::vector<vtkDataSet*>& blocks, const ArrayWish& wish)
{
  for (const bool ofCells : { false, true })
  {
    for (const DrawnArray& drawn : namedArrays(blocks, ofCells))
    {
      const std::string wrong = checkLengths(blocks, drawn);
      if (!wrong.empty() && (!wish.OfCells || *wish.OfCells == ofCells) &&
          (wish.Name.empty() || wish.Name == drawn.Array->GetName()))
      {
        return wrong;
      }
    }
  }
  return {};
}

} // namespace

bool namesNumbers(const std::string& name)
{
  static const std::set<std::string> words = { "id", "ids", "index", "indices", "number", "numbers",
    "num", "rank", "material", "materials", "mat", "block", "blocks", "region", "part", "process",
    "processor", "partition", "tag", "tags", "label", "labels", "type", "cellid", "cellids",
    "pointid", "pointids", "nodeid", "nodeids", "elementid", "elementids", "globalid", "globalids",
    "objectid", "blockid", "materialid", "regionid", "partid", "procid", "matid", "zoneid" };
  return words.count(lastWordOf(name)) > 0;
}

std::vector<FoundArray> findArrays(const std::vector<vtkDataSet*>& blocks)
{
  std::vector<FoundArray> all;
  for (const bool ofCells : { false, true })
  {
    for (const DrawnArray& drawn : namedArrays(blocks, ofCells))
    {
      if (checkLengths(blocks, drawn).empty())
      {
        FoundArray found;
        found.Drawn = drawn;
        found.Range = rangeOf(blocks, drawn);
        const std::vector<vtkDataArray*> parts = partsOf(blocks, drawn);
        found.Kind = kindOf(parts, found.Range);
        found.Everywhere = parts.size() == blocks.size();
        found.Floating = std::any_of(parts.begin(), parts.end(), isFloating);
        found.Active = isActive(blocks, drawn);
        all.push_back(found);
      }
    }
  }
  return all;
}

std::string chooseArray(
  const std::vector<vtkDataSet*>& blocks, const ArrayWish& wish, DrawnArray& chosen)
{
  const std::vector<FoundArray> all = findArrays(blocks);
  const FoundArray* best = nullptr;
  for (const FoundArray& found : all)
  {
    if (wish.OfCells && found.Drawn.OfCells != *wish.OfCells)
    {
      continue;
    }
    const bool isBetter = !best || (wish.Name.empty() ? rankOf(found) < rankOf(*best)
                                                      : found.Everywhere && !best->Everywhere);
    if (isBetter && (wish.Name.empty() || wish.Name == found.Drawn.Array->GetName()))
    {
      best = &found;
    }
  }
  if (!best)
  {
    const std::string misfit = describeMisfit(blocks, wish);
    if (!misfit.empty())
    {
      return misfit;
    }
    const std::string place = !wish.OfCells ? "" : *wish.OfCells ? " on cells" : " on points";
    return (wish.Name.empty() ? "the data has no array to draw" + place
                              : "there is no array '" + wish.Name + "'" + place) +
           " (" + listOf(all) + ")";
  }
  DrawnArray drawn = best->Drawn;
  const int components = drawn.Array->GetNumberOfComponents();
  const int wished = wish.Component.value_or(wish.Name.empty() ? -1 : 0);
  if (wished >= components)
  {
    return std::string("array '") + drawn.Array->GetName() + "' has no component " +
           std::to_string(wished) + ": it has " + std::to_string(components) + ", counted from 0";
  }
  drawn.Component = components == 1 ? 0 : wished;
  chosen = drawn;
  return {};
}

} // namespace tetmarch
