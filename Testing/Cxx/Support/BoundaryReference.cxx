// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryReference.h"

#include "Mesh/TetMeshBuilder.h"
#include "Optics/TransferFunctions.h"
#include "View/View.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 cross(const Vec3& a, const Vec3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

struct Line
{
  Vec3 Origin{};
  Vec3 Direction{};
  double Begin = -Infinity; // what lies between is seen
  double End = Infinity;
};

// Where a line crosses a face.
struct Meeting
{
  double Depth = 0.0;
  bool Enters = false;
  BoundaryPixel At;
};

bool meets(const Line& line, const TetMesh& mesh, int face, Meeting& meeting)
{
  std::array<Vec3, 3> p;
  for (int i = 0; i < 3; ++i)
  {
    const Vertex& v = mesh.Vertices[mesh.BoundaryFaces[face][i]];
    p[i] = { { double(v.X) - line.Origin[0], double(v.Y) - line.Origin[1],
      double(v.Z) - line.Origin[2] } };
  }
  Vec3 volumes;
  for (int i = 0; i < 3; ++i)
  {
    volumes[i] = dot(line.Direction, cross(p[(i + 1) % 3], p[(i + 2) % 3]));
  }
  // Corners turn counter-clockwise seen from outside, so that towards the viewer is negative.
  const bool enters = volumes[0] < 0.0 && volumes[1] < 0.0 && volumes[2] < 0.0;
  const bool leaves = volumes[0] > 0.0 && volumes[1] > 0.0 && volumes[2] > 0.0;
  const double sum = volumes[0] + volumes[1] + volumes[2];
  meeting = { 0.0, enters, { face, {} } };
  for (int i = 0; i < 3 && (enters || leaves); ++i)
  {
    meeting.At.Barycentrics[i] = volumes[i] / sum;
    meeting.Depth += meeting.At.Barycentrics[i] * dot(p[i], line.Direction);
  }
  return enters || leaves;
}

BoundaryPixel entryOf(const Line& line, const TetMesh& mesh)
{
  Meeting before; // the last entry before the line begins
  Meeting after;  // the first meeting behind that
  Meeting entry;  // the first entry behind that
  before.Depth = -Infinity;
  after.Depth = entry.Depth = Infinity;
  Meeting m;
  for (int face = 0; face < static_cast<int>(mesh.BoundaryFaces.size()); ++face)
  {
    if (!meets(line, mesh, face, m))
    {
      continue;
    }
    if (m.Depth <= line.Begin)
    {
      before = m.Enters && m.Depth > before.Depth ? m : before;
    }
    else
    {
      after = m.Depth < after.Depth ? m : after;
      entry = m.Enters && m.Depth < entry.Depth ? m : entry;
    }
  }
  const bool beginsInside = after.At.Face >= 0 && !after.Enters;
  const Meeting& found = beginsInside ? before : entry;
  return found.Depth < line.End ? found.At : BoundaryPixel();
}
} // namespace

BoundaryReference boundaryViewOf(Scene& scene, const std::vector<float>& depths)
{
  TetMesh mesh;
  std::string error;
  View view;
  if (buildTetMesh(scene.Data, {}, mesh, error) != BuildStatus::Done ||
      !makeView(scene.Renderer, scene.Volume, mesh.Frame, 1.0, OpacityLaw::Unstructured, view))
  {
    throw std::runtime_error("the scene has no mesh or no view: " + error);
  }
  const int width = scene.Renderer->GetSize()[0];
  const int height = scene.Renderer->GetSize()[1];
  BoundaryReference reference;
  for (const auto& face : mesh.BoundaryFaces)
  {
    reference.Faces.push_back({ { face[0], face[1], face[2] } });
  }
  for (int i = 0; i < width * height; ++i)
  {
    const double x = (i % width + 0.5) / width * 2.0 - 1.0;
    const double y = (i / width + 0.5) / height * 2.0 - 1.0;
    const double depth = depths.empty() ? 1.0 : double(depths[i]);
    const Vec3 far = view.unproject(x, y, 2.0 * depth - 1.0);
    Line line;
    line.Origin = view.unproject(x, y, -1.0);
    for (int k = 0; k < 3; ++k)
    {
      line.Direction[k] = line.Origin[k] * view.Eye[3] - view.Eye[k];
    }
    const double length = std::sqrt(dot(line.Direction, line.Direction));
    for (double& d : line.Direction)
    {
      d /= length;
    }
    line.Begin = view.CutsNearPlane ? 0.0 : -Infinity;
    if (depth < 1.0 || view.CutsFarPlane)
    {
      line.End = dot(far, line.Direction) - dot(line.Origin, line.Direction);
    }
    reference.Pixels.push_back(entryOf(line, mesh));
  }
  return reference;
}
} // namespace tetmarch::testing
