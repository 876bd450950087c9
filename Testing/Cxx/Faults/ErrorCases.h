// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Changes that make a scene impossible to draw, and the error that each gives
 */
#ifndef tetmarch_testing_ErrorCases_h
#define tetmarch_testing_ErrorCases_h

#include "BlankScenes.h"
#include "ComponentFields.h"
#include "OtherGrid.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"

#include <functional>
#include <type_traits>

namespace tetmarch::testing
{
template <typename SceneType>
class ErrorCases
{
public:
  struct Case
  {
    std::string Name;
    std::function<void(SceneType&)> Spoil;
    Words Said; // all of them in the error
  };
  std::vector<Case> All;

  void add(const std::string& name, const std::function<void(SceneType&)>& spoil, const Words& said)
  {
    this->All.push_back({ name, spoil, said });
  }
  /// Shows other data, which `make` returns.
  template <typename Make>
  void addData(const std::string& name, Make make, const Words& said)
  {
    this->add(
      name, [make](SceneType& s) { s.Mapper->SetInputDataObject(make()); }, said);
  }
  /// Shows the data of soundOf() with a change.
  template <typename Change>
  void addChange(const std::string& name, Change change, const Words& said)
  {
    const auto changed = [change]
    {
      const auto data = soundOf(static_cast<SceneType*>(nullptr));
      change(*data);
      return data;
    };
    this->addData(name, changed, said);
  }
  /// Chooses an array by VTK_SCALAR_MODE_... and by its name or number.
  template <typename NameOrNumber>
  void addArray(int scalarMode, NameOrNumber array, const Words& said)
  {
    const auto choose = [=](SceneType& s)
    {
      s.Mapper->SetScalarMode(scalarMode);
      s.Mapper->SelectScalarArray(array);
    };
    this->add("array", choose, said);
  }
  void addComponent(int scalarMode, const std::string& said)
  {
    const auto choose = [=](SceneType& s)
    {
      s.Mapper->SetScalarMode(scalarMode);
      s.Mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
      s.Mapper->SetVectorComponent(2);
    };
    this->add("component", choose, { said, "VectorComponent" });
  }
  void addViewRange(int viewMode, double low, double high, const std::string& said)
  {
    const auto set = [=](SceneType& s)
    {
      s.Mapper->SetViewMode(viewMode);
      s.Mapper->SetViewRange(low, high);
      s.Mapper->AutomaticViewRangeOff();
    };
    this->add("view range", set, { said, "SetViewRange()" });
  }
  void addBlendMode(int mode)
  {
    this->add("blend mode", [mode](SceneType& s) { s.Mapper->SetBlendMode(mode); },
      { "blend mode is " + std::to_string(mode), "isosurface (5)" });
  }

  /// Puts right what a case has spoilt, and changes nothing else.
  static void mend(SceneType& s)
  {
    if (s.Mapper->GetInputDataObject(0, 0) != s.Data)
    {
      s.Mapper->SetInputDataObject(s.Data);
    }
    s.Mapper->SetScalarModeToDefault();
    s.Mapper->SetVectorMode(vtkSmartVolumeMapper::DISABLED);
    s.Mapper->SetBlendModeToComposite();
    s.Mapper->SetViewModeToPicture();
    s.Mapper->SetMaxMemoryInBytes(0);
    s.property()->IndependentComponentsOn();
    s.property()->SetScalarOpacityUnitDistance(0.25);
    s.Volume->SetScale(1.0);
  }
};

inline void setFewScalars(vtkDataSetAttributes* attributes)
{
  vtkNew<vtkDoubleArray> few;
  few->SetName("few");
  few->SetNumberOfValues(5);
  few->Fill(0.5);
  attributes->SetScalars(few);
}

template <typename SceneType>
void addErrorsOfAnyMapper(ErrorCases<SceneType>& cases)
{
  using Settings = vtkTetMarchSettings;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double notANumber = std::nan("");
  const auto sound = soundOf(static_cast<SceneType*>(nullptr));
  const std::string points = std::to_string(sound->GetNumberOfPoints()) + " points";
  const std::string cells = std::to_string(sound->GetNumberOfCells()) + " cells";
  cases.addChange("no active scalars",
    [](vtkDataSet& data)
    {
      data.GetPointData()->SetActiveScalars(nullptr);
      data.GetCellData()->SetActiveScalars(nullptr);
    },
    { "no active scalars", "Point arrays: f", "cell arrays: c", "SelectScalarArray" });
  cases.addChange("no arrays",
    [](vtkDataSet& data)
    {
      data.GetPointData()->Initialize();
      data.GetCellData()->Initialize();
    },
    { "Point arrays: none", "cell arrays: none" });
  cases.addChange("few values of points",
    [](vtkDataSet& data) { setFewScalars(data.GetPointData()); },
    { "\"few\"", "5 tuples", points });
  cases.addChange("few values of cells",
    [](vtkDataSet& data)
    {
      data.GetPointData()->Initialize();
      setFewScalars(data.GetCellData());
    },
    { "\"few\"", "5 tuples", cells });
  cases.addArray(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "temperature",
    { "\"temperature\"", "in the point data", "f" });
  cases.addArray(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, "f", { "\"f\"", "in the cell data", "c" });
  cases.addArray(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, 7, { "number 7", "in the cell data" });
  cases.addArray(VTK_SCALAR_MODE_USE_FIELD_DATA, "f", { "Field data", "point or cell data" });
  cases.addComponent(VTK_SCALAR_MODE_DEFAULT, "\"f\" has no component 2");
  cases.addComponent(VTK_SCALAR_MODE_USE_CELL_DATA, "\"c\" has no component 2");
  for (const double bad : { 0.0, -1.0, notANumber })
  {
    cases.add("unit distance",
      [bad](SceneType& s) { s.property()->SetScalarOpacityUnitDistance(bad); },
      { "unit distance", "above 0" });
  }
  cases.add("a flat volume", [](SceneType& s) { s.Volume->SetScale(1.0, 0.0, 1.0); },
    { "matrix of the volume", "singular" });
  cases.add("too little memory", [](SceneType& s) { s.Mapper->SetMaxMemoryInBytes(100); },
    { "bytes", "MaxMemoryInBytes" });
  cases.addBlendMode(-1);
  cases.addBlendMode(99);
  std::vector<double> surfaces;
  for (int i = 0; i < 40; ++i)
  {
    surfaces.push_back(0.02 * i);
  }
  cases.add("surfaces", [surfaces](SceneType& s) { setIsoValues(s, surfaces); },
    { "40 isosurface values", "at most 32" });
  cases.addViewRange(Settings::VIEW_CELLS, 5.0, 5.0, "below the second");
  cases.addViewRange(Settings::VIEW_LOOKUPS, 6.0, 5.0, "below the second");
  cases.addViewRange(Settings::VIEW_CELLS, 0.0, infinite, "finite");
  cases.addViewRange(Settings::VIEW_CELLS, notANumber, 1.0, "finite");
  cases.addViewRange(Settings::VIEW_ERROR_BOUND, 0.0, 1.0, "begins above 0");
  cases.addViewRange(Settings::VIEW_ERROR_BOUND, -1.0, 1.0, "begins above 0");
}

inline void addErrorsOfOne(ErrorCases<Scene>& cases)
{
  const auto addCorner = [](vtkUnstructuredGrid& grid)
  {
    const vtkIdType corners[4] = { 0, 1, 2, 4711 };
    grid.InsertNextCell(VTK_TETRA, 4, corners);
    grid.GetCellData()->Initialize();
  };
  cases.addChange("no such point", addCorner, { "cell 384", "point 4711", "125 points" });
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    cases.addChange("coordinate",
      [bad](vtkUnstructuredGrid& grid) { grid.GetPoints()->SetPoint(33, 0.5, bad, 0.5); },
      { "point 33", "not a finite number" });
  }
  cases.addData("another kind of grid", [] { return vtkSmartPointer<OtherGrid>::New(); },
    { "OtherGrid", "vtkUnstructuredGrid" });
  cases.addBlendMode(vtkVolumeMapper::SLICE_BLEND); // VTK's mapper draws slices of images
}

inline void addErrorsOfOne(ErrorCases<ImageScene>& cases)
{
  for (const std::array<int, 3>& most :
    { std::array{ 0, 6, 6 }, std::array{ 6, 0, 6 }, std::array{ 6, 6, 0 }, std::array{ 0, 0, 6 } })
  {
    const auto makeFlat = [most]
    {
      ImagePlace place = unitCube(6);
      place.Extent = { { 0, most[0], 0, most[1], 0, most[2] } };
      return imageOf(sineField(), place);
    };
    std::string points;
    for (const int last : most)
    {
      points += (points.empty() ? "" : " x ") + std::to_string(last + 1);
    }
    cases.addData("flat data", makeFlat, { "image", points });
  }
  cases.addChange(
    "no spacing", [](vtkImageData& image) { image.SetSpacing(0.1, 0.0, 0.1); }, { "spacing" });
  const auto makeCreased = []
  {
    const auto grid = rectilinearOf(sineField(), unevenCube(6));
    grid->GetYCoordinates()->SetComponent(3, 0, grid->GetYCoordinates()->GetComponent(2, 0));
    return grid;
  };
  cases.addData("equal coordinates", makeCreased, { "y coordinate", "ascend" });
  const auto makeMesh = [] { return jitteredLattice(2, 0.1, 1, sineField()); };
  cases.addData(
    "a mesh", makeMesh, { "The input is a vtkUnstructuredGrid", "vtkTetMarchVolumeMapper" });
  const auto makeBlocks = [makeMesh]
  {
    const auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    tree->SetBlock(0, makeMesh());
    tree->SetBlock(1, vtkNew<vtkPolyData>());
    tree->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "wing");
    return tree;
  };
  cases.addData("no block of an image", makeBlocks,
    { "Block \"wing\"", "vtkUnstructuredGrid", "vtkTetMarchVolumeMapper", "No other block" });
  // Of dependent components none is chosen, as by vtkSmartVolumeMapper.
  const auto spoil = [](ImageScene& s)
  {
    const auto image = soundOf(&s);
    setComponents(image, { sineField(), sineField(), sineField() }, VTK_DOUBLE);
    s.Mapper->SetInputDataObject(image);
    s.Mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
    s.property()->IndependentComponentsOff();
  };
  cases.add("three dependent components", spoil,
    { "has 3 components", "IndependentComponents on", "VectorMode" });
  // A lattice has no boundary faces.
  for (const int mode :
    { vtkTetMarchSettings::VIEW_BOUNDARY_FACES, vtkTetMarchSettings::VIEW_BOUNDARY_COORDINATES })
  {
    cases.add("view mode", [mode](ImageScene& s) { s.Mapper->SetViewMode(mode); },
      { "boundary faces", "have none", "SetViewModeToCells()" });
  }
}
} // namespace tetmarch::testing

#endif
