// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileContents.h"

#include "ErrorText.h"
#include "Failure.h"
#include "FileReader.h"
#include "FileSeries.h"
#include "Messages.h"
#include "ReaderCrash.h"
#include "TimeSteps.h"

#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTetMarchImageReader.h"

#include <algorithm>
#include <filesystem>

namespace
{
using tetmarch::Failure;

/// By default the last one; 0 if there are none.
std::size_t ChooseStep(const std::vector<double>& times, std::optional<int> timeStep)
{
  const int count = static_cast<int>(times.size());
  if (timeStep && *timeStep >= count)
  {
    throw Failure(
      "time step " + std::to_string(*timeStep) + " does not exist: the file has " +
      (count == 0 ? "no time steps"
                  : std::to_string(count) + ", counted from 0 to " + std::to_string(count - 1)));
  }
  return static_cast<std::size_t>(timeStep.value_or(std::max(count - 1, 0)));
}

void Update(vtkAlgorithm* reader, std::optional<int> timeStep)
{
  const std::vector<double> times = tetmarch::GetTimeSteps(reader);
  const std::size_t chosen = ChooseStep(times, timeStep);
  if (!times.empty())
  {
    reader->UpdateTimeStep(times[chosen]);
  }
  else
  {
    reader->Update();
  }
}

/// Pieces of a parallel file repeat the points between them and their neighbours' cells.
bool HasPieces(const std::string& path)
{
  return tetmarch::GetEnding(path).compare(0, 4, ".pvt") == 0;
}

/// As Update(). Returns what our own reader said of the file, or an empty string.
std::string UpdateAndListen(vtkAlgorithm* reader, std::optional<int> timeStep)
{
  std::optional<tetmarch::ErrorText> error;
  if (vtkTetMarchImageReader::SafeDownCast(reader))
  {
    error.emplace(reader);
  }
  Update(reader, timeStep);
  return error ? error->Get() : std::string();
}

tetmarch::FileContents ReadOneFile(const std::string& path, std::optional<int> timeStep,
  const tetmarch::RawOptions& raw, const tetmarch::ProgressReport& report)
{
  using namespace tetmarch;
  CheckFile(path);
  const int errorsBefore = Messages::GetNumberOfErrors();
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(path, raw);
  std::string complaint;
  {
    ProgressBar progress("reading", reader, report);
    complaint = UpdateAndListen(reader, timeStep);
    if (progress.IsStopped())
    {
      throw Cancelled("reading '" + path + "' was cancelled");
    }
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (Messages::GetNumberOfErrors() > errorsBefore || !complaint.empty() || !data ||
      reader->GetErrorCode() != 0)
  {
    throw Failure("cannot read '" + path + "': " +
                  (complaint.empty() ? "the file is damaged or not of the kind that its ending says"
                                     : complaint));
  }
  return { data, GetTimeSteps(reader), HasPieces(path) };
}

/// Several files are the blocks of a tree.
tetmarch::FileContents ReadStep(
  const std::string& list, std::optional<int> timeStep, const tetmarch::ProgressReport& report)
{
  using namespace tetmarch;
  const FileSeries series = ReadSeries(list);
  FileContents contents;
  contents.Times = GetTimes(series);
  const SeriesStep& step = series.Steps[ChooseStep(contents.Times, timeStep)];
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const SeriesPart& part : step.Parts)
  {
    if (!std::filesystem::exists(part.Path))
    {
      throw Failure("cannot read '" + list + "': it lists '" + part.Path + "', which isn't there");
    }
    const FileContents read =
      WhileReading(part.Path, [&] { return ReadOneFile(part.Path, std::nullopt, {}, report); });
    const unsigned int number = tree->GetNumberOfBlocks();
    tree->SetBlock(number, read.Data);
    if (!part.Name.empty())
    {
      tree->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), part.Name.c_str());
    }
    contents.OfPieces = contents.OfPieces || read.OfPieces;
    contents.Data = read.Data;
  }
  if (step.Parts.size() > 1)
  {
    contents.Data = tree;
  }
  return contents;
}
} // namespace

namespace tetmarch
{

FileContents ReadFile(const std::string& path, std::optional<int> timeStep, const RawOptions& raw,
  const ProgressReport& report)
{
  return IsSeriesFile(path)
           ? ReadStep(path, timeStep, report)
           : WhileReading(path, [&] { return ReadOneFile(path, timeStep, raw, report); });
}

} // namespace tetmarch
