// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of VTK's tests about vectors, components, and the types of numbers.
#include "ImageScene.h"

#include "ComponentFields.h"
#include "LatticeImages.h"
#include "VtkScene.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
using Data = vtkSmartPointer<vtkDataSet>;

// Fields of the unit cube as components of one array at the points of an image of 24^3 cells.
vtkSmartPointer<vtkImageData> withComponents(const std::vector<Field>& fields, int type)
{
  const auto image = imageOf(fields[0], unitCube(24));
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("components");
  array->SetNumberOfComponents(static_cast<int>(fields.size()));
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    for (std::size_t c = 0; c < fields.size(); ++c)
    {
      array->SetComponent(i, static_cast<int>(c), fields[c](p[0], p[1], p[2]));
    }
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

// Of other values in every direction, each from 0 to 1: VTK takes colours, and the opacities of a
// second component, by the range of theirs.
vtkSmartPointer<vtkImageData> makeWaves(int count)
{
  const std::vector<Field> fields = { sineField(1.0), radialField(), linearField(),
    sineField(1.5) };
  const auto image = withComponents({ fields.begin(), fields.begin() + count }, VTK_FLOAT);
  vtkDataArray* array = image->GetPointData()->GetScalars();
  for (int c = 0; c < count; ++c)
  {
    double range[2];
    array->GetRange(range, c);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->SetComponent(i, c, (array->GetComponent(i, c) - range[0]) / (range[1] - range[0]));
    }
  }
  array->Modified();
  return image;
}

// The same in bytes.
Data makeColours()
{
  const auto image = makeWaves(4);
  vtkDataArray* from = image->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < 4 * from->GetNumberOfTuples(); ++i)
  {
    bytes->InsertNextValue(
      static_cast<unsigned char>(std::lround(255.0 * from->GetComponent(i / 4, i % 4))));
  }
  image->GetPointData()->SetScalars(bytes);
  return image;
}

// Each in a layer of its own, 0 elsewhere.
Data makeApart(int count)
{
  std::vector<Field> fields;
  for (int c = 0; c < count; ++c)
  {
    fields.push_back([=](double x, double, double)
      { return std::max(0.0, 1.0 - std::abs(2.0 * (count * x - c) - 1.0)); });
  }
  return withComponents(fields, VTK_FLOAT);
}

// About 0, as VTK's test has it, the second one ten times as long as the others.
Data makeVectors()
{
  return withComponents({ [](double x, double, double) { return 20.0 * x - 10.0; },
                          [](double, double y, double) { return 200.0 * y - 100.0; },
                          [](double, double, double z) { return 20.0 * z - 10.0; } },
    VTK_DOUBLE);
}

// Of all components: where the functions are those of component 0, VTK 9.1 takes the distance of
// the component that is shown, or of the last one.
void setUnitDistances(ImageStage& stage, double distance)
{
  for (int c = 0; c < 4; ++c)
  {
    stage.Property->SetScalarOpacityUnitDistance(c, distance);
  }
}

std::function<void(ImageStage&)> vectors(int mode, int component)
{
  return [=](ImageStage& stage)
  {
    setFunctions(
      stage.Property, mode == vtkSmartVolumeMapper::MAGNITUDE ? 0.0 : -100.0, 101.0, 0.9);
    setUnitDistances(stage, 0.3);
    stage.Mapper->SetVectorMode(mode);
    stage.Mapper->SetVectorComponent(component);
  };
}

std::function<void(ImageStage&)> components(int count, bool independent)
{
  return [=](ImageStage& stage)
  {
    setComponentFunctions(stage.Property, count);
    stage.Property->SetIndependentComponents(independent);
    stage.Property->SetInterpolationTypeToLinear();
    setUnitDistances(stage, 0.25);
  };
}

// Of which nothing is seen where a component is 0; without weights.
std::function<void(ImageStage&)> apart(int count)
{
  return [=](ImageStage& stage)
  {
    components(count, true)(stage);
    for (int c = 0; c < count; ++c)
    {
      vtkNew<vtkPiecewiseFunction> opacities;
      opacities->AddPoint(0.0, 0.0);
      opacities->AddPoint(0.3, 0.1 + 0.1 * c);
      opacities->AddPoint(1.0, 0.6);
      stage.Property->SetScalarOpacity(c, opacities);
      stage.Property->SetComponentWeight(c, 1.0);
    }
  };
}

// Of four components three are the colour, in bytes; the functions are of the fourth.
void rgba(ImageStage& stage)
{
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(20.0, 0.0);
  opacities->AddPoint(255.0, 0.7);
  stage.Property->SetScalarOpacity(opacities);
  setUnitDistances(stage, 0.2);
  stage.Property->SetIndependentComponents(0);
  stage.Property->SetInterpolationTypeToLinear();
}

ImageScene typed(const char* test, int type, int mode, int interpolation, RivalError rival)
{
  const auto make = [type]() -> Data
  {
    const auto image = imageOf(sineField(), unitCube(12));
    convertScalars(image, type);
    return image;
  };
  const auto arrange = [=](ImageStage& stage)
  {
    const std::array<double, 2> range = rangeInType(type);
    setFunctions(stage.Property, range[0], range[1], 0.9);
    stage.Property->SetScalarOpacityUnitDistance(0.3);
    stage.Property->SetInterpolationType(interpolation);
    stage.Mapper->SetBlendMode(mode);
  };
  const auto name = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  return { std::string(test) + ", " + name->GetDataTypeAsString(), make, arrange, rival };
}
} // namespace

std::vector<ImageScene> imageArrayScenes()
{
  std::vector<ImageScene> scenes = {
    { "GPURayCastIndependentVectorMode, magnitude", makeVectors,
      vectors(vtkSmartVolumeMapper::MAGNITUDE, 0),
      { 2.0, "its steps miss the ends of short ways" } },
    { "GPURayCastIndependentVectorMode, component", makeVectors,
      vectors(vtkSmartVolumeMapper::COMPONENT, 1),
      { 2.0, "its steps miss the ends of short ways" } },
    { "GPURayCastTwoComponentsIndependent", [] { return makeApart(2); }, apart(2), {} },
    { "GPURayCastThreeComponentsIndependent", [] { return makeApart(3); }, apart(3), {} },
    { "GPURayCastFourComponentsIndependent", [] { return makeApart(4); }, apart(4), {} },
    { "GPURayCastFourComponentsIndependent, mixed", [] { return Data(makeWaves(4)); },
      components(4, true), { 60.0, "where two meet, it absorbs less than it sends out" } },
    { "GPURayCastTwoComponentsDependent", [] { return Data(makeWaves(2)); }, components(2, false),
      {} },
    { "GPURayCastFourComponentsComposite", makeColours, rgba, {} },
  };
  const char* steps = "its steps miss what short ways have";
  for (const int type : numberTypes())
  {
    const bool refused = type == VTK_CHAR || type == VTK_ID_TYPE;
    const RivalError none = { NoPicture, "VTK 9.1 refuses that type" };
    scenes.push_back(typed("GPURayCastDataTypes", type, vtkVolumeMapper::COMPOSITE_BLEND,
      VTK_LINEAR_INTERPOLATION, refused ? none : RivalError{ 2.5, steps }));
    scenes.push_back(typed("GPURayCastDataTypesMIP", type, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
      VTK_LINEAR_INTERPOLATION, refused ? none : RivalError{ 5.0, steps }));
  }
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_INT, VTK_DOUBLE })
  {
    scenes.push_back(typed("GPURayCastDataTypesMinIP", type,
      vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, VTK_LINEAR_INTERPOLATION, { 3.0, steps }));
    scenes.push_back(typed("GPURayCastNearestDataTypesMIP", type,
      vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, VTK_NEAREST_INTERPOLATION, { 10.0, steps }));
  }
  return scenes;
}
} // namespace tetmarch::testing
