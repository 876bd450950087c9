// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonScript.h"

#include "FileReader.h"
#include "NumberText.h"
#include "RawImage.h"
#include "StateWords.h"

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <type_traits>

namespace
{
using namespace tetmarch;

/// Strings of JSON are strings of Python, too.
std::string Quote(const std::string& text)
{
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string Bool(bool value) { return value ? "True" : "False"; }

template <typename Points>
std::string ToPoints(const Points& points)
{
  std::string text = "[";
  for (const auto& point : points)
  {
    text += "\n    (" + ToList(point) + "),";
  }
  return text + "\n]";
}

std::string WriteReader(const DataState& data)
{
  static const std::set<std::string> exodus = { ".ex2", ".ex2v2", ".exo", ".exoii", ".e", ".g" };
  const std::string ending = GetEnding(data.File);
  const std::string name = "reader.SetFileName(" + Quote(data.File) + ")\n";
  if (exodus.count(ending))
  {
    return "reader = vtk.vtkExodusIIReader()\n" + name +
           "reader.UpdateInformation()\n"
           "reader.SetAllArrayStatus(reader.NODAL, 1)\n"
           "reader.SetAllArrayStatus(reader.ELEM_BLOCK, 1)\n";
  }
  if (ending == ".cgns")
  {
    return "reader = vtk.vtkCGNSReader()\n" + name +
           "reader.UpdateInformation()\nreader.EnableAllBases()\nreader.EnableAllFamilies()\n"
           "reader.EnableAllPointArrays()\nreader.EnableAllCellArrays()\n";
  }
  if (ending == ".vtk")
  {
    return "reader = vtk.vtkGenericDataObjectReader()\n" + name +
           "reader.ReadAllScalarsOn()\nreader.ReadAllVectorsOn()\nreader.ReadAllFieldsOn()\n";
  }
  if (IsRawFile(data.File))
  {
    const RawOptions raw = CompleteRawOptions({}, data.File);
    const auto& n = *raw.Dimensions;
    return "reader = vtk.vtkImageReader2()\n" + name + "reader.SetFileDimensionality(3)\n" +
           "reader.SetDataExtent(0, " + std::to_string(n[0] - 1) + ", 0, " +
           std::to_string(n[1] - 1) + ", 0, " + std::to_string(n[2] - 1) +
           ")\nreader.SetDataScalarType(" + std::to_string(*raw.Type) +
           ")\nreader.SetDataByteOrderToLittleEndian()\n";
  }
  if (IsImageFile(data.File))
  {
    return "reader = vtkTetMarchImageReader()\n" + name;
  }
  if (ending == ".vth" || ending == ".vthb")
  {
    return "reader = vtk.vtkXMLUniformGridAMRReader()\n" + name +
           "reader.SetMaximumLevelsToReadByDefault(0)\n";
  }
  static const std::map<std::string, std::string> others = {
    { ".vtpc", "vtkXMLPartitionedDataSetCollectionReader" },
    { ".vtpd", "vtkXMLPartitionedDataSetReader" },
    { ".htg", "vtkXMLHyperTreeGridReader" },
    { ".p3d", "vtkPlot3DMetaReader" },
  };
  const auto other = others.find(ending);
  return "reader = vtk." +
         (other == others.end() ? "vtkXMLGenericDataObjectReader" : other->second) + "()\n" + name;
}

std::string WriteData(const DataState& data, bool structured)
{
  std::string text = WriteReader(data);
  if (data.TimeStep >= 0)
  {
    text += "reader.UpdateInformation()\n"
            "times = reader.GetOutputInformation(0).Get("
            "vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())\n"
            "reader.UpdateTimeStep(times[" +
            std::to_string(data.TimeStep) + "])\n";
  }
  text += "reader.Update()\ndata = reader.GetOutputDataObject(0)\n";
  if (!structured)
  {
    text += "if not isinstance(data, (vtk.vtkUnstructuredGrid, vtk.vtkStructuredGrid, "
            "vtk.vtkHyperTreeGrid,\n"
            "                         vtk.vtkCompositeDataSet)):\n"
            "    tree = vtk.vtkMultiBlockDataSet()\n"
            "    tree.SetBlock(0, data)\n"
            "    data = tree\n";
  }
  text += std::string("\nmapper = ") +
          (structured ? "vtkTetMarchSmartVolumeMapper" : "vtkTetMarchVolumeMapper") +
          "()\nmapper.SetInputDataObject(data)\n" +
          (data.Association == 1 ? "mapper.SetScalarModeToUseCellFieldData()\n"
                                 : "mapper.SetScalarModeToUsePointFieldData()\n") +
          "mapper.SelectScalarArray(" + Quote(data.Array) + ")\n";
  if (data.Component < 0)
  {
    return text + "mapper.SetVectorMode(mapper.MAGNITUDE)\n";
  }
  return text + "mapper.SetVectorMode(mapper.COMPONENT)\nmapper.SetVectorComponent(" +
         std::to_string(data.Component) + ")\n";
}

/// Those of light if the volume is lit.
struct SettingWriter
{
  std::string& Text;
  bool Lit;

  void Call(const SettingNames& names, const std::string& value, const std::string& comment)
  {
    if (this->Lit || !names.OfLight)
    {
      this->Text += std::string("mapper.Set") + names.Property + "(" + value + ")" + comment + "\n";
    }
  }
  template <typename Value>
  void operator()(const SettingNames& names, Value value)
  {
    if constexpr (std::is_same_v<Value, bool>)
    {
      this->Call(names, Bool(value), "");
    }
    else
    {
      this->Call(names, ToText(value), "");
    }
  }
  template <typename Words>
  void Choice(const SettingNames& names, int number, const Words& words)
  {
    this->Call(names, std::to_string(number), std::string("  # ") + words.at(number));
  }
};

std::string WriteSettings(const ViewState& state, bool structured)
{
  const EffectState& effects = state.Effects;
  std::string text = "mapper.SetBlendMode(" + std::to_string(state.BlendMode) + ")  # " +
                     BlendWords.at(state.BlendMode) + "\nmapper.SetOpacityLawTo" +
                     (state.Functions.StructuredOpacityLaw ? "Structured" : "Unstructured") +
                     "()\n";
  VisitSettings(SettingWriter{ text, effects.Shading }, state.Settings);
  constexpr int sampled = 4;
  if (state.Settings.AccuracyLevel == sampled && structured)
  {
    text += "mapper.SetSampleDistance(-1)\nmapper.InteractiveAdjustSampleDistancesOff()\n"
            "mapper.AutoAdjustSampleDistancesOff()\n";
  }
  if (effects.Shading)
  {
    text += "mapper.SetVolumetricScatteringBlending(" +
            ToText(effects.Scattering ? effects.ScatteringStrength : 0.0) + ")\n";
  }
  if (state.Cuts.Clip)
  {
    text += "plane = vtk.vtkPlane()\nplane.SetOrigin(" + ToList(state.Cuts.Origin) +
            ")\nplane.SetNormal(" + ToList(state.Cuts.Normal) +
            ")\nmapper.AddClippingPlane(plane)\n";
  }
  if (state.Cuts.Crop)
  {
    text += "mapper.CroppingOn()\nmapper.SetCroppingRegionPlanes(" + ToList(state.Cuts.Box) +
            ")\nmapper.SetCroppingRegionFlagsToSubVolume()\n";
  }
  return text;
}

std::string WriteProperty(const ViewState& state)
{
  const FunctionState& functions = state.Functions;
  const EffectState& effects = state.Effects;
  std::string text =
    "\nvolume = vtk.vtkVolume()\nvolume.SetMapper(mapper)\n"
    "property = volume.GetProperty()\n"
    "color = vtk.vtkColorTransferFunction()\n"
    "color.AllowDuplicateScalarsOn()\n"
    "color.SetColorSpace(" +
    std::to_string(functions.ColorSpace) + ")  # " + ColorSpaceWords.at(functions.ColorSpace) +
    "\ncolor.SetHSVWrap(" + Bool(functions.HSVWrap) + ")\n" +
    (functions.LogScale ? "color.SetScaleToLog10()\n" : "") + "color.SetNanColorRGBA(" +
    ToList(functions.NanColor) + ")\nfor point in " + ToPoints(functions.Color) +
    ":\n    color.AddRGBPoint(*point)\n"
    "property.SetColor(color)\n"
    "opacity = vtk.vtkPiecewiseFunction()\n"
    "opacity.AllowDuplicateScalarsOn()\nfor point in " +
    ToPoints(functions.Opacity) +
    ":\n    opacity.AddPoint(*point)\n"
    "property.SetScalarOpacity(opacity)\n"
    "property.SetScalarOpacityUnitDistance(" +
    ToText(functions.UnitDistance) + ")\nproperty.SetInterpolationTypeTo" +
    (state.Data.Nearest ? "Nearest" : "Linear") + "()\n";
  if (effects.GradientOpacity)
  {
    text += "gradient_opacity = vtk.vtkPiecewiseFunction()\nfor point in " +
            ToPoints(functions.GradientOpacity) +
            ":\n    gradient_opacity.AddPoint(*point)\n"
            "property.SetGradientOpacity(gradient_opacity)\n";
  }
  constexpr int isosurface = 5;
  if (state.BlendMode == isosurface)
  {
    text += "for i, value in enumerate([" + ToList(state.IsoValues) +
            "]):\n    property.GetIsoSurfaceValues().SetValue(i, value)\n";
  }
  if (effects.Shading)
  {
    text += "property.ShadeOn()\nproperty.SetAmbient(" + ToText(effects.Ambient) +
            ")\nproperty.SetDiffuse(" + ToText(effects.Diffuse) + ")\nproperty.SetSpecular(" +
            ToText(effects.Specular) + ")\nproperty.SetSpecularPower(" +
            ToText(effects.SpecularPower) + ")\n";
  }
  return text;
}

std::string WriteLight(const EffectState& effects)
{
  if (!effects.Shading)
  {
    return {};
  }
  return "light = vtk.vtkLight()\nlight.SetIntensity(" + ToText(effects.Intensity) + ")\n" +
         (effects.Headlight ? "light.SetLightTypeToHeadlight()\n"
                            : "light.SetLightTypeToSceneLight()\nlight.SetPosition(" +
                                ToList(effects.LightFrom) + ")\nlight.SetFocalPoint(0, 0, 0)\n") +
         "renderer.AddLight(light)\n";
}

std::string WriteSurface(const std::string& path)
{
  if (path.empty())
  {
    return {};
  }
  const bool legacy = GetEnding(path) == ".vtk";
  return std::string("surface_reader = vtk.") +
         (legacy ? "vtkGenericDataObjectReader" : "vtkXMLGenericDataObjectReader") +
         "()\nsurface_reader.SetFileName(" + Quote(path) +
         ")\nsurface_reader.Update()\n"
         "surface_mapper = vtk.vtkPolyDataMapper()\n"
         "surface_mapper.SetInputDataObject(surface_reader.GetOutputDataObject(0))\n"
         "surface_mapper.ScalarVisibilityOff()\n"
         "surface = vtk.vtkActor()\nsurface.SetMapper(surface_mapper)\n"
         "surface.GetProperty().SetColor(0.8, 0.8, 0.8)\nrenderer.AddActor(surface)\n";
}

std::string WriteView(const ViewState& state)
{
  const CameraState& camera = state.Camera;
  std::string text =
    "\nrenderer = vtk.vtkRenderer()\nrenderer.SetBackground(" + ToList(state.Background) +
    ")\nrenderer.AddVolume(volume)\nlegend = vtkTetMarchLegend()\n"
    "legend.SetMapper(mapper)\nrenderer.AddViewProp(legend)\n" +
    WriteSurface(state.Data.Surface) + WriteLight(state.Effects) +
    "camera = renderer.GetActiveCamera()\ncamera.SetPosition(" + ToList(camera.Position) +
    ")\ncamera.SetFocalPoint(" + ToList(camera.FocalPoint) + ")\ncamera.SetViewUp(" +
    ToList(camera.ViewUp) + ")\ncamera.SetViewAngle(" + ToText(camera.ViewAngle) + ")\n";
  if (camera.Parallel)
  {
    text += "camera.ParallelProjectionOn()\ncamera.SetParallelScale(" +
            ToText(camera.ParallelScale) + ")\n";
  }
  return text + "window = vtk.vtkRenderWindow()\nwindow.SetMultiSamples(0)\nwindow.SetSize(" +
         std::to_string(state.Size[0]) + ", " + std::to_string(state.Size[1]) +
         ")\nwindow.AddRenderer(renderer)\nrenderer.ResetCameraClippingRange()\n";
}
} // namespace

std::string tetmarch::WriteScript(const ViewState& state, bool structured)
{
  return "import sys\n\nimport vtkmodules.all as vtk\n"
         "from vtktetmarch import " +
         std::string(IsImageFile(state.Data.File) ? "vtkTetMarchImageReader, " : "") +
         "vtkTetMarchLegend, " +
         std::string(structured ? "vtkTetMarchSmartVolumeMapper" : "vtkTetMarchVolumeMapper") +
         "\n\n" + WriteData(state.Data, structured) + WriteSettings(state, structured) +
         WriteProperty(state) + WriteView(state) +
         "\nif len(sys.argv) > 1:  # the name of a PNG file\n"
         "    window.SetOffScreenRendering(1)\n"
         "    window.Render()\n"
         "    image = vtk.vtkWindowToImageFilter()\n"
         "    image.SetInput(window)\n"
         "    image.ShouldRerenderOff()\n"
         "    image.ReadFrontBufferOff()\n"
         "    writer = vtk.vtkPNGWriter()\n"
         "    writer.SetInputConnection(image.GetOutputPort())\n"
         "    writer.SetFileName(sys.argv[1])\n"
         "    writer.Write()\n"
         "else:\n"
         "    interactor = vtk.vtkRenderWindowInteractor()\n"
         "    interactor.SetRenderWindow(window)\n"
         "    interactor.SetInteractorStyle(vtk.vtkInteractorStyleTrackballCamera())\n"
         "    window.Render()\n"
         "    interactor.Start()\n";
}
