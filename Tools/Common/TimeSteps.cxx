// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeSteps.h"

#include "Failure.h"
#include "FileReader.h"
#include "FileSeries.h"
#include "Messages.h"
#include "ReaderCrash.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace tetmarch
{

std::vector<double> GetTimeSteps(vtkAlgorithm* reader)
{
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (!information->Has(key))
  {
    return {};
  }
  const double* times = information->Get(key);
  return { times, times + information->Length(key) };
}

std::vector<double> GetTimeSteps(const std::string& path, const RawOptions& rawOptions)
{
  if (IsSeriesFile(path))
  {
    return GetTimes(ReadSeries(path));
  }
  CheckFile(path);
  const int errorsBefore = Messages::GetNumberOfErrors();
  std::vector<double> times =
    WhileReading(path, [&] { return GetTimeSteps(MakeReader(path, rawOptions)); });
  if (Messages::GetNumberOfErrors() > errorsBefore)
  {
    throw Failure(
      "cannot read '" + path + "': the file is damaged or not of the kind that its ending says");
  }
  return times;
}

} // namespace tetmarch
