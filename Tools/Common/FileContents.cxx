// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileContents.h"

#include "Failure.h"
#include "FileReader.h"
#include "LibraryOutput.h"
#include "Messages.h"
#include "TimeSteps.h"

#include "vtkImageReader2.h"
#include "vtkMetaImageReader.h"

namespace
{
using tetmarch::Failure;

/// Reads the chosen time step, by default the last.
void Update(vtkAlgorithm* reader, std::optional<int> timeStep)
{
  const std::vector<double> times = tetmarch::GetTimeSteps(reader);
  const int count = static_cast<int>(times.size());
  if (timeStep && *timeStep >= count)
  {
    throw Failure(
      "time step " + std::to_string(*timeStep) + " does not exist: the file has " +
      (count == 0 ? "no time steps"
                  : std::to_string(count) + ", counted from 0 to " + std::to_string(count - 1)));
  }
  if (count > 0)
  {
    reader->UpdateTimeStep(times[timeStep.value_or(count - 1)]);
  }
  else
  {
    reader->Update();
  }
}

/// The same of a reader that leaves it to others to say that it failed: returns what they said, or
/// an empty string.
std::string UpdateAndListen(vtkAlgorithm* reader, std::optional<int> timeStep)
{
  const int warningsBefore = tetmarch::Messages::GetNumberOfWarningsOfNobody();
  std::optional<tetmarch::LibraryOutput> output;
  if (vtkMetaImageReader::SafeDownCast(reader))
  {
    output.emplace(); // MetaIO goes on after what it prints
  }
  Update(reader, timeStep);
  const bool warned = vtkImageReader2::SafeDownCast(reader) &&
                      tetmarch::Messages::GetNumberOfWarningsOfNobody() > warningsBefore;
  return output ? output->GetFirstLine() : warned ? "see the warning" : std::string();
}
} // namespace

namespace tetmarch
{

FileContents ReadFile(const std::string& path, std::optional<int> timeStep, const RawOptions& raw,
  const ProgressReport& report)
{
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
    throw Failure("cannot read '" + path +
                  "': the file is damaged or not of the kind that its ending says" +
                  (complaint.empty() ? "" : " (" + complaint + ")"));
  }
  return { data, GetTimeSteps(reader) };
}

} // namespace tetmarch
