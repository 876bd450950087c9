// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The hard cases from the command line: list them, write their grids, send rays through them.
#include "HardCase.h"
#include "StressRun.h"

#include "vtkNew.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace tetmarch::testing;

constexpr const char* Usage = R"(usage: tetmarch-hard-cases COMMAND

  list                  group, name, number of cells and description of each case
  write NAME FILE.vtu   its grid, with the point scalars "f" and the cell scalars "c"
  stress [OPTION]...    send rays through all cases, and print a table
      --rays N          total number over all cases, including earlier runs (1000000000)
      --least-rays N    minimum number of each case (1000000)
      --seconds S       stop after this time; a later run resumes from the file
      --file FILE.json  the file of the sums, from which a run resumes (stress.json)
      --table FILE.md   write the table there, too
      --case NAME       only this case
)";

int list()
{
  for (const HardCase& hard : hardCases())
  {
    std::cout << hard.Group << '\t' << hard.Name << '\t' << hard.Make()->GetNumberOfCells() << '\t'
              << hard.What << '\n';
  }
  return EXIT_SUCCESS;
}

int write(const std::string& name, const std::string& file)
{
  const HardCase* hard = findHardCase(name);
  if (!hard)
  {
    std::cerr << "there is no case named " << name << "; `list` names them all\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(hard->Make());
  writer->SetFileName(file.c_str());
  return writer->Write() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int stress(const std::vector<std::string>& arguments)
{
  StressOptions options;
  options.File = "stress.json";
  std::string tableFile;
  for (std::size_t i = 0; i < arguments.size(); i += 2)
  {
    const std::string& name = arguments[i];
    const std::string value = i + 1 < arguments.size() ? arguments[i + 1] : "";
    if (name == "--rays")
    {
      options.Rays = std::stoll(value);
    }
    else if (name == "--least-rays")
    {
      options.LeastRays = std::stoll(value);
    }
    else if (name == "--seconds")
    {
      options.Seconds = std::stod(value);
    }
    else if (name == "--file")
    {
      options.File = value;
    }
    else if (name == "--table")
    {
      tableFile = value;
    }
    else if (name == "--case")
    {
      options.Only = value;
    }
    else
    {
      std::cerr << "unknown option: " << name << '\n' << Usage;
      return EXIT_FAILURE;
    }
  }
  const auto rows =
    runStress(options, [](const std::string& line) { std::cerr << line << std::endl; });
  const std::string table = stressTable(rows);
  std::cout << table;
  if (!tableFile.empty())
  {
    std::ofstream(tableFile) << table;
  }
  int status = EXIT_SUCCESS;
  for (const StressRow& row : rows)
  {
    if (row.Totals.failures() > 0)
    {
      std::cout << row.Case->Name << ": " << row.Totals.FirstFailure << '\n';
      status = EXIT_FAILURE;
    }
  }
  return status;
}
} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try
  {
    if (arguments.size() == 1 && arguments[0] == "list")
    {
      return list();
    }
    if (arguments.size() == 3 && arguments[0] == "write")
    {
      return write(arguments[1], arguments[2]);
    }
    if (!arguments.empty() && arguments[0] == "stress")
    {
      return stress({ arguments.begin() + 1, arguments.end() });
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cerr << Usage;
  return EXIT_FAILURE;
}
