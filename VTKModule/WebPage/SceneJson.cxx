// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/SceneJson.h"

#include "WebPage/FunctionJson.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace tetmarch
{
namespace
{

// JSON has no number that is not finite.
Json::Value numberOf(double x)
{
  return std::isfinite(x) ? Json::Value(x) : Json::Value(x > 0 ? "inf" : x < 0 ? "-inf" : "nan");
}

template <typename Numbers>
Json::Value listOf(const Numbers& numbers)
{
  Json::Value list(Json::arrayValue);
  for (const auto x : numbers)
  {
    list.append(numberOf(static_cast<double>(x)));
  }
  return list;
}

std::array<double, 3> tripleOf(const double* p) { return { { p[0], p[1], p[2] } }; }

Json::Value featuresOf(const VariantKey& key)
{
  Json::Value names(Json::arrayValue);
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    if (feature.isOn(key))
    {
      names.append(feature.Name);
    }
  }
  return names;
}

Json::Value textureOf(const CapturedTexture& texture, PageArrays& arrays)
{
  using Shape = CapturedTexture::Shape;
  Json::Value json;
  json["kind"] = texture.Kind == Shape::Buffer  ? "buffer"
                 : texture.Kind == Shape::Image ? "2d"
                                                : "2d-array";
  json["format"] = texture.Format;
  json["width"] = texture.Width;
  json["height"] = texture.Height;
  json["layers"] = texture.Layers;
  json["array"] = arrays.add(texture.Type, texture.Bytes.data(), texture.Bytes.size(),
    texture.Components * sizeOfNumber(texture.Type));
  return json;
}

Json::Value programOf(const CapturedProgram& program, PageArrays& arrays)
{
  Json::Value json;
  json["uniforms"] = Json::Value(Json::objectValue);
  for (const auto& [name, uniform] : program.Uniforms)
  {
    json["uniforms"][name]["type"] = uniform.Type;
    json["uniforms"][name]["values"] = listOf(uniform.Values);
  }
  json["textures"] = Json::Value(Json::objectValue);
  for (const auto& [name, texture] : program.Textures)
  {
    json["textures"][name] = textureOf(texture, arrays);
  }
  return json;
}

Json::Value levelOf(const AccuracyLevel& level)
{
  Json::Value json;
  json["adaptive"] = level.Adaptive;
  json["sampled"] = level.Sampled;
  json["tolerance"] = level.ErrorTolerance;
  json["trials"] = level.MostTrials;
  return json;
}

int functionsNeeded(const VariantKey& key, const CapturedProgram& program)
{
  const auto count = program.Uniforms.find("componentCount");
  return key.Components == ComponentGroup::Independent && count != program.Uniforms.end()
           ? static_cast<int>(count->second.Values.front())
           : 1;
}

Json::Value volumeOf(const CaptureScope::Captured& captured, PageArrays& arrays)
{
  const CapturedVolume& data = captured.Data;
  vtkVolumeProperty* property = captured.Volume->GetProperty();
  Json::Value json = programOf(data.Program, arrays);
  json["name"] = captured.Name;
  json["features"] = featuresOf(data.Key);
  json["frame"]["center"] = listOf(data.Frame.Center);
  json["frame"]["radius"] = data.Frame.Radius;
  json["frame"]["halfExtent"] = listOf(data.Frame.HalfExtent);
  const double* matrix = captured.Volume->GetMatrix()->GetData();
  json["matrix"] = listOf(std::vector<double>(matrix, matrix + 16));
  json["unitDistance"] = property->GetScalarOpacityUnitDistance();
  json["law"] = captured.Law == OpacityLaw::Structured ? "structured" : "unstructured";
  json["range"] = listOf(std::array<double, 2>{ { data.Range.Low, data.Range.High } });
  json["extraRanges"] = Json::Value(Json::arrayValue);
  for (const ScalarRange& range : data.ExtraRanges)
  {
    json["extraRanges"].append(listOf(std::array<double, 2>{ { range.Low, range.High } }));
  }
  json["level"] = levelOf(data.Level);
  json["functions"] = Json::Value(Json::arrayValue);
  for (int i = 0; i < functionsNeeded(data.Key, data.Program); ++i)
  {
    const ScalarRange& range = i == 0 ? data.Range : data.ExtraRanges[i - 1];
    json["functions"].append(functionsOf(property, i, range.Low, range.High));
  }
  json["dataPlanes"] = Json::Value();
  for (const std::vector<double>& planes : data.DataPlanes)
  {
    if (!planes.empty())
    {
      json["dataPlanes"].append(listOf(planes));
    }
  }
  json["cells"] =
    data.Cells.empty()
      ? Json::Value()
      : Json::Value(arrays.add("uint32", data.Cells.data(), 4 * data.Cells.size(), 4));
  return json;
}

template <typename T>
Json::Value arrayOf(const char* type, const std::vector<T>& values, int texel, PageArrays& arrays)
{
  return values.empty()
           ? Json::Value()
           : Json::Value(arrays.add(type, values.data(), sizeof(T) * values.size(), texel));
}

Json::Value lightsOf(const std::vector<SurfaceLight>& lights)
{
  Json::Value list(Json::arrayValue);
  for (const SurfaceLight& light : lights)
  {
    Json::Value json;
    json["followsCamera"] = light.FollowsCamera;
    json["direction"] = listOf(light.Direction);
    json["color"] = listOf(light.Color);
    list.append(json);
  }
  return list;
}

Json::Value surfaceOf(const Surface& surface, PageArrays& arrays)
{
  Json::Value json;
  json["matrix"] = listOf(surface.Matrix);
  json["positions"] = arrayOf("float32", surface.Positions, 12, arrays);
  json["normals"] = arrayOf("float32", surface.Normals, 12, arrays);
  json["colors"] = arrayOf("uint8", surface.Colors, 4, arrays);
  json["tableCoordinates"] = arrayOf("float32", surface.TableCoordinates, 8, arrays);
  json["table"] = arrayOf("uint8", surface.Table, 4, arrays);
  json["tableWidth"] = surface.TableWidth;
  json["triangles"] = arrayOf("uint32", surface.Triangles, 4, arrays);
  json["color"] = listOf(surface.Color);
  json["ambientColor"] = listOf(surface.AmbientColor);
  json["ambient"] = surface.Ambient;
  json["diffuse"] = surface.Diffuse;
  json["specular"] = surface.Specular;
  json["specularColor"] = listOf(surface.SpecularColor);
  json["specularPower"] = surface.SpecularPower;
  json["lighting"] = surface.Lighting;
  json["lights"] = lightsOf(surface.Lights);
  json["flat"] = surface.Flat;
  json["frontFaces"] = surface.FrontFaces;
  json["backFaces"] = surface.BackFaces;
  return json;
}

} // namespace

void addView(vtkRenderer* renderer, Json::Value& scene)
{
  const int* size = renderer->GetSize();
  scene["size"] = listOf(std::array<int, 2>{ { size[0], size[1] } });
  scene["background"] = listOf(tripleOf(renderer->GetBackground()));
  scene["background2"] = renderer->GetGradientBackground()
                           ? listOf(tripleOf(renderer->GetBackground2()))
                           : Json::Value();
  vtkCamera* camera = renderer->GetActiveCamera();
  Json::Value& json = scene["camera"];
  json["position"] = listOf(tripleOf(camera->GetPosition()));
  json["focalPoint"] = listOf(tripleOf(camera->GetFocalPoint()));
  json["viewUp"] = listOf(tripleOf(camera->GetViewUp()));
  json["viewAngle"] = camera->GetViewAngle();
  json["parallelProjection"] = camera->GetParallelProjection() != 0;
  json["parallelScale"] = camera->GetParallelScale();
  const double* range = camera->GetClippingRange();
  json["clippingRange"] = listOf(std::array<double, 2>{ { range[0], range[1] } });
}

Json::Value stepOf(const std::string& label, const std::list<CaptureScope::Captured>& volumes,
  const std::vector<Surface>& surfaces, PageArrays& arrays)
{
  Json::Value step;
  step["label"] = label;
  step["volumes"] = Json::Value(Json::arrayValue);
  vtkVolume* before = nullptr;
  int group = -1;
  for (const CaptureScope::Captured& volume : volumes)
  {
    group += volume.Volume == before ? 0 : 1; // blocks of the same volume
    before = volume.Volume;
    Json::Value json = volumeOf(volume, arrays);
    json["group"] = group;
    step["volumes"].append(json);
  }
  step["surfaces"] = Json::Value(Json::arrayValue);
  for (const Surface& surface : surfaces)
  {
    step["surfaces"].append(surfaceOf(surface, arrays));
  }
  return step;
}

Json::Value rowsOf(const PageArrays& arrays)
{
  Json::Value rows(Json::arrayValue);
  for (const PageArrays::Row& row : arrays.rows())
  {
    Json::Value json;
    json["type"] = row.Type;
    json["count"] = static_cast<Json::UInt64>(row.Count);
    json["filter"] = row.Shuffled;
    json["parts"] = Json::Value(Json::arrayValue);
    for (int i = 0; i < row.Parts; ++i)
    {
      json["parts"].append("a" + std::to_string(row.FirstPart + i));
    }
    rows.append(json);
  }
  return rows;
}

std::string textOf(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  builder["precision"] = 17;
  const std::string text = Json::writeString(builder, value);
  std::string safe;
  for (const char c : text)
  {
    safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  }
  return safe;
}

} // namespace tetmarch
