// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exercise.h"

#include "Blocks/DataFaults.h"
#include "FirstPicture/ArrayChoice.h"
#include "FirstPicture/ArrayTable.h"
#include "FirstPicture/CameraFit.h"
#include "FirstPicture/DrawnBlocks.h"
#include "FirstPicture/Exposure.h"
#include "Mesh/LeastTetrahedra.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/TetMeshBuilder.h"
#include "Optics/FittingTable.h"
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"
#include "Reference/ReferenceImage.h"

#include "MarchedLength.h"
#include "MarchedMesh.h"
#include "RandomRays.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tetmarch::testing
{
namespace
{
constexpr int RaysOfEachKernel = 24;
constexpr int PixelsOfASide = 6;

void require(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "This doesn't hold: %s\n", what);
    std::abort();
  }
}

void checkLinks(const TetMesh& mesh)
{
  const Id tets = mesh.numberOfTets();
  require(mesh.Links.size() == 4 * mesh.Tets.size(), "each half-face has a link");
  for (Id halfFace = 0; halfFace < 4 * tets; ++halfFace)
  {
    const Id link = mesh.Links[halfFace];
    if (link >= LinkOutside)
    {
      const Id face = link - LinkOutside;
      require(face < mesh.BoundaryFaces.size() && mesh.BoundaryFaces[face][3] == halfFace,
        "a link to the outside leads to the half-face's boundary face");
      continue;
    }
    require(link < 4 * tets && link / 4 != halfFace / 4, "a link leads to another tetrahedron");
    require(mesh.Links[link] == halfFace, "what lies behind a face has the link back");
  }
  for (const Vertex& v : mesh.Vertices)
  {
    require(std::abs(v.X) <= 1.0f && std::abs(v.Y) <= 1.0f && std::abs(v.Z) <= 1.0f,
      "vertices lie in the normalised frame");
  }
}

template <typename Kernel, typename Real>
void marchRays(const TetMesh& mesh, Kernel kernel, unsigned seed)
{
  LengthMarcher<Kernel, Real> lengths(mesh);
  RandomRays random(seed);
  for (int i = 0; i < RaysOfEachKernel; ++i)
  {
    const auto ray = random.next<Kernel, Real>(kernel, mesh);
    const auto march = kernel.castPlainRay(ray, Real(1 << (i % 20)), Real(-3e38f), Real(3e38f));
    require(march.lost == 0, "no ray is lost");
    require(march.refused == 0, "no entry is refused");
    require(march.guarded == 0, "no ray goes round in circles");
    const Real t = march.radiance.transmittance;
    const auto& c = march.radiance.color;
    const Real most = Real(1.0 + 1e-5);
    require(t >= 0 && t <= most, "transmittances are in 0..1");
    require(c.x >= 0 && c.x <= most && c.y >= 0 && c.y <= most && c.z >= 0 && c.z <= most,
      "colours are in 0..1");
    const double length = lengths.march(ray).Length;
    require(length >= 0 && length <= 2 + 1e-5, "no ray crosses more than the mesh is wide");
  }
}

template <typename Kernel, typename Real>
Kernel kernelFor(const TetMesh& mesh, const IntegralTable& table, const ScalarRange& range)
{
  auto kernel = kernelOf<Kernel, Real>(mesh, table, DefaultAccuracy);
  kernel.tableScale = Real(table.scale(range.width()));
  kernel.tableOffset = Real(table.offset(range.Low));
  return kernel;
}

// From the front, in parallel projection.
void drawPicture(const TetMesh& mesh, const IntegralTable& table, const ScalarRange& range,
  const std::vector<float>* cellScalars)
{
  ReferenceScene scene;
  scene.Mesh = &mesh;
  scene.Table = &table;
  scene.Range = range;
  scene.CellScalars = cellScalars;
  scene.Width = scene.Height = PixelsOfASide;
  for (int i = 0; i < 4; ++i)
  {
    scene.Camera.NormalizedToClip[5 * i] = 1;
    scene.Camera.ClipToNormalized[5 * i] = 1;
  }
  scene.Camera.ThicknessMatrix = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  scene.Camera.Eye = { 0, 0, 1, 0 };
  const ReferenceImage image = renderReference<float>(scene, DefaultAccuracy);
  require(image.Counters.Lost + image.Counters.Refused + image.Counters.Guarded == 0,
    "no pixel's ray is lost, refused or guarded");
  for (const float value : image.Pixels)
  {
    require(value >= 0 && value <= 1 + 1e-5f, "pixels are in 0..1");
  }
}
// All that vtkTetMarchFirstPicture does with data that checkBlocks() has found sound.
void chooseFirstPicture(vtkDataObject* data)
{
  const auto owned = drawnBlocks(data);
  const std::vector<vtkDataSet*> blocks(owned.begin(), owned.end());
  const std::vector<Vector3> outline = outlinePoints(blocks);
  const PicturePlane plane = choosePlane(outline);
  vtkNew<vtkCamera> camera;
  fitCamera(outline, plane, 1.5, camera);
  vtkNew<vtkTable> arrays;
  listArrays(blocks, arrays);
  DrawnArray drawn;
  if (!chooseArray(blocks, {}, drawn).empty())
  {
    return;
  }
  require(!describe(blocks, drawn).empty(), "what is drawn has a description");
  const Crossings crossings = findCrossings(blocks, drawn, outline, plane);
  for (const bool lattice : { false, true })
  {
    for (std::vector<Sample> samples : { takeSamples(blocks, drawn), crossings.samples() })
    {
      const ValueStatistics statistics =
        computeStatistics(std::move(samples), std::nullopt, lattice);
      const double width = statistics.Range[1] - statistics.Range[0];
      require(width > 0 && std::isfinite(width), "a range can be divided by its width");
      vtkNew<vtkPiecewiseFunction> opacity;
      const double distance =
        exposeFirstOpacity(statistics, crossings, { lattice, !lattice }, opacity);
      require(distance > 0 && std::isfinite(distance), "a unit distance can be divided by");
    }
  }
}
} // namespace

std::string exercise(const Bytes& bytes)
{
  vtkObject::GlobalWarningDisplayOff();
  const FuzzInput input = decode(bytes);
  vtkDataSetAttributes* attributes =
    input.OfCells ? static_cast<vtkDataSetAttributes*>(input.Cells->GetCellData())
                  : input.Cells->GetPointData();
  attributes->AddArray(input.Scalars);
  const std::string fault = checkBlocks(input.Cells);
  listFaults(input.Cells);
  if (fault.empty())
  {
    chooseFirstPicture(input.Cells);
  }
  leastTetrahedra(input.Cells, 0); // comes before anything is checked
  TetMesh mesh;
  std::string error;
  const BuildStatus status = buildTetMesh(input.Cells, {}, mesh, error);
  require(fault.empty() || error == fault, "what is checked first has the mapper's error");
  require(status != BuildStatus::Stopped, "a build that nobody stopped isn't stopped");
  require((status == BuildStatus::Failed) == !error.empty(), "failures come with an error");
  if (error.empty())
  {
    checkLinks(mesh);
    ensureHierarchy(mesh);
    checkLinks(mesh);
    error = checkScalars(input.Cells, input.Scalars, input.OfCells);
  }
  if (!error.empty() || mesh.Tets.empty())
  {
    return error.empty() ? "Nothing to draw." : error;
  }
  const MeshScalars scalars = readScalars(input.Cells, { input.Scalars, input.OfCells }, mesh);
  const ScalarRange& range = scalars.Range;
  const IntegralTable table =
    fittingTable(input.Property, input.Law, range.Low, range.High, DefaultAccuracy);
  drawPicture(mesh, table, range, input.OfCells ? &scalars.OfCells : nullptr);
  if (input.OfCells)
  {
    return {};
  }
  marchRays<PointKernel<float>, float>(
    mesh, kernelFor<PointKernel<float>, float>(mesh, table, range), input.Seed);
  marchRays<PortablePointKernel<float>, float>(
    mesh, kernelFor<PortablePointKernel<float>, float>(mesh, table, range), input.Seed);
  marchRays<PointKernel<double>, double>(
    mesh, kernelFor<PointKernel<double>, double>(mesh, table, range), input.Seed);
  return {};
}
} // namespace tetmarch::testing
