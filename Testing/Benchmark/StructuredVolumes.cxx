// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredVolumes.h"

#include "Failure.h"
#include "Numbers.h"

#include "vtkDataArray.h"
#include "vtkDataSetReader.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace tetmarch::bench
{
namespace
{
constexpr double Pi = 3.141592653589793;
// Of these the diagonal has so many: most rays get through a part of the volume only.
constexpr double UnitsInDiagonal = 40.0;

const std::map<std::string, std::string>& filesByName()
{
  static const std::map<std::string, std::string> files = {
    { "bonsai", "bonsai.vti" },
    { "aneurism", "aneurism.vti" },
    { "headsq", "headsq_64x64x93.vti" },
    { "carotid", "carotid.vtk" },
  };
  return files;
}

std::string pathOf(const std::string& file, const DataFolders& folders)
{
  return folders.Others + "/structured/" + file;
}

/// N of "marschner-lobb:N".
std::optional<int> marschnerLobbSize(const std::string& name)
{
  const std::string prefix = "marschner-lobb:";
  if (name.compare(0, prefix.size(), prefix) != 0)
  {
    return std::nullopt;
  }
  const auto size = ParseInteger(name.substr(prefix.size()));
  return size && *size > 1 ? size : std::nullopt;
}

/// Marschner and Lobb, "An Evaluation of Reconstruction Filters for Volume Rendering", 1994: the
/// sum of a term of x and y and one of z, each taken once, since 512^3 points are many.
vtkSmartPointer<vtkImageData> makeMarschnerLobb(int size)
{
  constexpr double frequency = 6.0;
  constexpr double alpha = 0.25;
  constexpr double most = 2.0 * (1.0 + alpha);
  const double spacing = 2.0 / (size - 1);
  const auto at = [spacing](int i) { return -1.0 + i * spacing; };
  std::vector<double> ripples;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const double angle = 2.0 * Pi * frequency * std::cos(0.5 * Pi * std::hypot(at(x), at(y)));
      ripples.push_back(alpha * (1.0 + std::cos(angle)) / most);
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetOrigin(at(0), at(0), at(0));
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkFloatArray> values;
  values->SetName("values");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  float* value = values->GetPointer(0);
  for (int z = 0; z < size; ++z)
  {
    const double slope = (1.0 - std::sin(0.5 * Pi * at(z))) / most;
    value = std::transform(ripples.begin(), ripples.end(), value,
      [slope](double ripple) { return static_cast<float>(slope + ripple); });
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkImageData> readImage(const std::string& file)
{
  vtkSmartPointer<vtkImageData> image;
  if (std::filesystem::path(file).extension() == ".vti")
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    image = reader->GetOutput();
  }
  else
  {
    vtkNew<vtkDataSetReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    image = vtkImageData::SafeDownCast(reader->GetOutput());
  }
  if (!image || image->GetNumberOfPoints() == 0)
  {
    throw Failure("there is no image in " + file);
  }
  return image;
}

/// The image with these values in float, or their magnitude.
vtkSmartPointer<vtkImageData> inFloat(vtkImageData* image, vtkDataArray* values)
{
  vtkNew<vtkFloatArray> floats;
  floats->SetName("values");
  floats->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    double sum = 0.0;
    for (int k = 0; k < values->GetNumberOfComponents(); ++k)
    {
      sum += values->GetComponent(i, k) * values->GetComponent(i, k);
    }
    const bool single = values->GetNumberOfComponents() == 1;
    floats->SetValue(i, static_cast<float>(single ? values->GetComponent(i, 0) : std::sqrt(sum)));
  }
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  result->GetPointData()->SetScalars(floats);
  return result;
}
} // namespace

bool isStructuredVolume(const std::string& name)
{
  return filesByName().count(name) || marschnerLobbSize(name);
}

bool isStructuredPresent(const std::string& name, const DataFolders& folders)
{
  const auto file = filesByName().find(name);
  return file == filesByName().end() || std::filesystem::exists(pathOf(file->second, folders));
}

StructuredVolume makeStructuredVolume(const std::string& name, const DataFolders& folders)
{
  StructuredVolume volume;
  if (const auto size = marschnerLobbSize(name))
  {
    volume.Stored = makeMarschnerLobb(*size);
    volume.Floats = volume.Stored;
  }
  else
  {
    volume.Stored = readImage(pathOf(filesByName().at(name), folders));
    vtkPointData* data = volume.Stored->GetPointData();
    vtkDataArray* values = data->GetScalars() ? data->GetScalars() : data->GetVectors();
    if (!values)
    {
      throw Failure(name + " has neither scalars nor vectors of points");
    }
    volume.Floats = inFloat(volume.Stored, values);
    if (values->GetNumberOfComponents() > 1 || values->GetDataType() == VTK_FLOAT)
    {
      volume.Stored = volume.Floats;
    }
  }
  double range[2];
  volume.Floats->GetPointData()->GetScalars()->GetRange(range);
  volume.Range = { range[0], range[1], volume.Floats->GetLength() / UnitsInDiagonal };
  const double* spacing = volume.Floats->GetSpacing();
  volume.Voxel = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  return volume;
}
} // namespace tetmarch::bench
