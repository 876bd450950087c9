// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Surfaces for a page, of a renderer without a window
 */
#ifndef tetmarch_testing_SurfacesOfRenderer_h
#define tetmarch_testing_SurfacesOfRenderer_h

#include "Geometry/Vector3.h"
#include "OpaqueProps.h"
#include "Shot.h"
#include "WebPage/SceneSurfaces.h"

#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tetmarch::testing
{
inline vtkSmartPointer<vtkFloatArray> arrayOf(const char* name, const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (const float value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// A quadrilateral over the points 0 1 3 2 below a strip of two triangles over 4 5 6 7, and a
// vertex.
inline vtkSmartPointer<vtkPolyData> patch()
{
  vtkNew<vtkPoints> points;
  for (const double y : { 0.0, 1.0, 1.0, 2.0 })
  {
    points->InsertNextPoint(10.0, y, 0.0);
    points->InsertNextPoint(11.0, y, 0.0);
  }
  vtkNew<vtkCellArray> vertices, polygons, strips;
  vertices->InsertNextCell({ 0 });
  polygons->InsertNextCell({ 0, 1, 3, 2 });
  strips->InsertNextCell({ 4, 5, 6, 7 });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  return data;
}

/// The surfaces of a renderer without a window.
class SurfacesOfRenderer : public ::testing::Test
{
protected:
  std::vector<Surface> surfaces(BlockAttributes attributes = nullptr)
  {
    std::vector<std::string> omissions;
    return opaqueSurfaces(this->Renderer, omissions, attributes);
  }

  Surface only()
  {
    const auto found = this->surfaces();
    return found.size() == 1 ? found.front() : throw std::length_error("not one surface");
  }

  vtkActor* add(vtkPolyData* data)
  {
    const auto actor = actorOf(data);
    this->Renderer->AddActor(actor);
    return actor;
  }

  /// Of a point in the world.
  static Vector3 placeOf(const Surface& surface, std::size_t point)
  {
    double q[4] = { 0.0, 0.0, 0.0, 1.0 };
    std::copy_n(surface.Positions.begin() + 3 * point, 3, q);
    vtkMatrix4x4::MultiplyPoint(surface.Matrix.data(), q, q);
    return { { q[0], q[1], q[2] } };
  }

  vtkNew<WindowlessRenderer> Renderer;
};
} // namespace tetmarch::testing

#endif
