// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayList.h"

#include "TextTable.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkVariant.h"

#include <cmath>
#include <sstream>

namespace tetmarch
{

namespace
{

std::string ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string FormatTimes(const std::vector<double>& times)
{
  if (times.empty())
  {
    return "no time steps\n";
  }
  return "time steps: 0 to " + std::to_string(times.size() - 1) + ", times " +
         ToText(times.front()) + " to " + ToText(times.back()) + "\n";
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
    {
      const double value = arrays->GetValueByName(row, column).ToDouble();
      return std::isnan(value) ? std::string("-") : ToText(value);
    };
    const bool drawn = text("name") == chosen && text("association") == place;
    rows.push_back({ drawn ? "*" : "", text("name"), text("association"), text("type"),
      text("components"), number("minimum"), number("maximum"), text("kind") });
  }
  return FormatTable(rows) + "* is drawn unless --array says otherwise\n" + FormatTimes(times);
}

} // namespace tetmarch
