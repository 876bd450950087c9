// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayList.h"

#include "FirstPicture/RangeText.h"
#include "TextTable.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkVariant.h"

#include <cmath>

namespace tetmarch
{

namespace
{

/// Of an array without finite values, which are not numbers, dashes.
std::array<std::string, 2> ToTexts(double low, double high)
{
  return low <= high ? rangeText(low, high) : std::array<std::string, 2>{ { "-", "-" } };
}

std::string FormatTimes(const std::vector<double>& times)
{
  if (times.empty())
  {
    return "no time steps\n";
  }
  const auto [first, last] = rangeText(times.front(), times.back());
  return "time steps: 0 to " + std::to_string(times.size() - 1) + ", times " + first + " to " +
         last + "\n";
}

} // namespace

std::string FormatArrayList(vtkTetMarchFirstPicture* choice, const std::vector<double>& times)
{
  vtkNew<vtkTable> arrays;
  choice->ListArrays(arrays);
  const std::string chosen = choice->GetChosenArray()->GetName();
  const std::string place =
    choice->GetChosenAssociation() == vtkTetMarchFirstPicture::CELLS ? "cells" : "points";

  std::vector<std::vector<std::string>> rows = { { "", "array", "on", "type", "components",
    "minimum", "maximum", "kind" } };
  for (vtkIdType row = 0; row < arrays->GetNumberOfRows(); ++row)
  {
    const auto text = [&](const char* column)
    { return std::string(arrays->GetValueByName(row, column).ToString()); };
    const auto number = [&](const char* column)
    { return arrays->GetValueByName(row, column).ToDouble(); };
    auto [low, high] = ToTexts(number("minimum"), number("maximum"));
    if (std::isnan(number("minimum")))
    {
      low = high = "-";
    }
    const bool drawn = text("name") == chosen && text("association") == place;
    rows.push_back({ drawn ? "*" : "", text("name"), text("association"), text("type"),
      text("components"), low, high, text("kind") });
  }
  return FormatTable(rows) + "* is drawn unless --array says otherwise\n" + FormatTimes(times);
}

} // namespace tetmarch
