// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray of one pixel as plain text.
#include "PixelTrace.h"

#include "TextTable.h"

#include "vtkTetMarchFrameStatistics.h"

#include "vtkDataArray.h"

#include <sstream>

namespace tetmarch
{
namespace
{
using Row = std::vector<std::string>;

constexpr int Digits = 7; // what a float has

std::string FormatList(const std::vector<double>& numbers)
{
  std::string text;
  for (double number : numbers)
  {
    text += (text.empty() ? "" : ", ") + FormatNumber(number, Digits);
  }
  return text;
}

std::string FormatScalars(vtkTable* cells, const char* column, vtkIdType row)
{
  std::vector<double> scalars;
  const int components = cells->GetColumnByName(column)->GetNumberOfComponents();
  for (int k = 0; k < components; ++k)
  {
    scalars.push_back(GetCellValue(cells, column, row, k));
  }
  return FormatList(scalars);
}

void AppendColor(Row& row, const std::array<double, 4>& color)
{
  for (double channel : color)
  {
    row.push_back(FormatFixed(channel, Digits));
  }
}

std::string DescribeCell(vtkTable* cells, vtkIdType row, bool structured)
{
  std::vector<std::string> notes;
  if (GetCellValue(cells, "EntersMesh", row) != 0.0)
  {
    notes.push_back(structured ? "enters the grid" : "enters the mesh");
  }
  const std::string outcome = cells->GetValueByName(row, "Outcome").ToString();
  const bool hasPart = outcome != "empty" && outcome != "out of range";
  if (hasPart && GetCellValue(cells, "Begin", row) > GetCellValue(cells, "Enter", row))
  {
    notes.push_back("from " + FormatNumber(GetCellValue(cells, "Begin", row), Digits));
  }
  if (hasPart && GetCellValue(cells, "End", row) < GetCellValue(cells, "Leave", row))
  {
    notes.push_back("to " + FormatNumber(GetCellValue(cells, "End", row), Digits));
  }
  if (outcome != "gathered")
  {
    notes.push_back(outcome);
  }
  std::string text;
  for (const std::string& note : notes)
  {
    text += (text.empty() ? "" : ", ") + note;
  }
  return text;
}

bool HasBlocks(vtkTable* cells)
{
  return cells->GetNumberOfRows() > 0 && GetCellValue(cells, "Block", 0) != 0.0;
}

std::string FormatCells(vtkTable* cells, bool structured)
{
  std::vector<Row> rows{ { "row", "cell", structured ? "lattice" : "tet", "enter", "leave",
    "scalar in", "scalar out", "opacity", "red", "green", "blue", "alpha", "bound", "lookups",
    "note" } };
  const bool blocks = HasBlocks(cells);
  if (blocks)
  {
    rows[0].insert(rows[0].begin() + 1, "block");
  }
  for (vtkIdType i = 0; i < cells->GetNumberOfRows(); ++i)
  {
    const auto value = [&](const char* column, int digits = Digits)
    { return FormatNumber(GetCellValue(cells, column, i), digits); };
    const auto integer = [&](const char* column)
    { return std::to_string(static_cast<vtkIdType>(GetCellValue(cells, column, i))); };
    Row row{ std::to_string(i) };
    if (blocks)
    {
      row.push_back(integer("Block"));
    }
    row.insert(row.end(), { integer("CellId"), integer("Tetrahedron"), value("Enter"),
                            value("Leave"), FormatScalars(cells, "ScalarEnter", i),
                            FormatScalars(cells, "ScalarLeave", i), value("Opacity", 4) });
    AppendColor(row, { { GetCellValue(cells, "Color", i, 0), GetCellValue(cells, "Color", i, 1),
                       GetCellValue(cells, "Color", i, 2), GetCellValue(cells, "Color", i, 3) } });
    row.insert(row.end(),
      { value("ErrorBound", 3), integer("Lookups"), DescribeCell(cells, i, structured) });
    rows.push_back(row);
  }
  return FormatTable(rows);
}

std::string FormatRay(const char* title, vtkTable* cells, bool structured)
{
  std::ostringstream text;
  text << "\n" << title << ": ";
  if (cells->GetNumberOfRows() == 0)
  {
    text << (structured ? "the ray passes no cell.\n" : "the ray passes no tetrahedron.\n");
    return text.str();
  }
  text << "the ray passes " << cells->GetNumberOfRows() << (structured ? " cells" : " tetrahedra")
       << (GetRayValue(cells, "Opaque") != 0.0 ? " and ends there, opaque" : "") << ".\n"
       << FormatCells(cells, structured);
  for (const auto& [name, what] :
    { std::pair<const char*, const char*>{ "RefusedEntries", "boundary faces refused the ray" },
      { "LostRays", structured ? "cells had no exit" : "tetrahedra had no exit" },
      { "GuardHits", "times the step guard ended it" } })
  {
    if (GetRayValue(cells, name) != 0.0)
    {
      text << "Something is wrong: " << GetRayValue(cells, name) << " " << what << ".\n";
    }
  }
  return text.str();
}

Row FormatTotal(const char* title, vtkTable* cells)
{
  Row row{ title };
  AppendColor(row, GetRayColor(cells));
  row.insert(row.end(),
    { FormatNumber(GetRayValue(cells, "ErrorBound"), 3), std::to_string(cells->GetNumberOfRows()),
      std::to_string(static_cast<vtkIdType>(GetRayValue(cells, "Lookups"))), "" });
  return row;
}

Row FormatDifference(
  const char* title, const std::array<double, 4>& a, const std::array<double, 4>& b)
{
  Row row{ title };
  for (int k = 0; k < 4; ++k)
  {
    row.push_back(FormatNumber(a[k] - b[k], 3));
  }
  row.insert(row.end(), { "", "", "", "" });
  return row;
}

std::string FormatTotals(const PixelTrace& trace)
{
  Row drawn{ "picture (GPU)" };
  AppendColor(drawn, trace.Drawn);
  drawn.insert(drawn.end(), { "", "", "", "" });
  const auto inFloat = GetRayColor(trace.Float);
  return FormatTable({ { "", "red", "green", "blue", "alpha", "bound",
                         trace.Structured ? "cells" : "tets", "lookups", "" },
    drawn, FormatTotal("float", trace.Float), FormatTotal("double", trace.Double),
    FormatTotal("ground truth", trace.GroundTruth),
    FormatDifference("picture - float", trace.Drawn, inFloat),
    FormatDifference("float - double", inFloat, GetRayColor(trace.Double)),
    FormatDifference(
      "double - ground truth", GetRayColor(trace.Double), GetRayColor(trace.GroundTruth)) });
}

std::string FormatParting(const PixelTrace& trace)
{
  const vtkIdType row = FindParting(trace.Float, trace.Double);
  const std::string cells = trace.Structured ? "cells" : "tetrahedra";
  return row < 0 ? "In float and in double the ray passes the same " + cells + ".\n"
                 : "In float and in double the ray passes different " + cells + " from row " +
                     std::to_string(row) + " on.\n";
}
} // namespace

std::string FormatPixelText(const CommandLine& commandLine, const std::string& arrayName,
  vtkTetMarchFrameStatistics* statistics, const PixelTrace& trace)
{
  const auto [x, y] = *commandLine.Pixel;
  vtkTable* ray = trace.Double;
  const auto list = [ray](const char* name, int count)
  {
    std::vector<double> numbers;
    for (int k = 0; k < count; ++k)
    {
      numbers.push_back(GetRayValue(ray, name, k));
    }
    return FormatList(numbers);
  };
  std::ostringstream text;
  text << "Pixel " << x << "," << y << " of " << commandLine.Size[0] << "x" << commandLine.Size[1]
       << ", counted from the upper left (" << x << "," << commandLine.Size[1] - 1 - y
       << " from the lower left).\n"
       << "Array " << arrayName << ", accuracy " << statistics->GetUsedAccuracyLevelAsString()
       << ", tolerance " << FormatNumber(statistics->GetUsedErrorTolerance(), Digits) << ".\n"
       << "The ray starts on the near plane, in (" << list("Origin", 3) << "), towards ("
       << list("Direction", 3) << ").\n"
       << "Lengths are counted from there. It gathers from " << list("Range", 1) << " to "
       << FormatNumber(GetRayValue(ray, "Range", 1), Digits) << ".\n"
       << FormatRay("In float, as on the GPU", trace.Float, trace.Structured)
       << FormatRay("In double", trace.Double, trace.Structured) << "\n"
       << FormatTotals(trace) << FormatParting(trace);
  return text.str();
}

} // namespace tetmarch
