// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TetSource.h"

#include "Caching/WithinMemory.h"
#include "Entries/EntryListLimit.h"
#include "Mesh/MeshSizes.h"
#include "Mesh/PackedCells.h"
#include "Rays/View.h"
#include "Variants/VariantKey.h"
#include "Volume/TransparentShare.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

std::string TetSource::updateGeometry(
  vtkDataSet* data, const ResourceLimits& limits, const Progress& progress)
{
  this->Limits = limits;
  return this->Volume.updateGeometry(vtkUnstructuredGrid::SafeDownCast(data), limits, progress);
}

std::vector<FiniteRange> TetSource::rangesOf(vtkDataSet* data, const DrawnScalars& drawn)
{
  return this->Volume.rangesOf(vtkUnstructuredGrid::SafeDownCast(data), drawn);
}

std::string TetSource::updateScalars(vtkDataSet* data, const DrawnScalars& drawn)
{
  return this->Volume.updateScalars(vtkUnstructuredGrid::SafeDownCast(data), drawn);
}

std::string TetSource::updateVisibility(
  const IntegralTable& first, const Components& parts, const Blending& blending, bool undrawnSeen)
{
  const std::string error =
    this->Volume.updateVisiblePart(parts.isIndependent() ? nullptr : &first, blending, undrawnSeen);
  const VisiblePart& part = this->Volume.visiblePart();
  this->EntersVisible.update(isWorthEntering(part), staysWorthEntering(part), this->version());
  return error;
}

double TetSource::transparentShare(const IntegralTable& table) const
{
  const MeshScalars& scalars = this->Volume.scalars();
  return tetmarch::transparentShare(this->mesh(), scalars.OfCells, scalars.Range, table);
}

bool TetSource::entersVisiblePart() const
{
  const VisiblePart& part = this->Volume.visiblePart();
  return this->EntersVisible.isOn() && part.Faces.size() <= this->Limits.TexelsPerBuffer;
}

void TetSource::setBits(VariantKey& key, const View& camera) const
{
  key.PointScalars = this->Volume.scalars().OfCells.empty();
  key.EntryLists = !camera.CutsNearPlane;
  key.Hierarchy = this->mayReenter();
  key.HiddenCells = !this->Volume.hiddenCells().empty();
  key.VisiblePart = this->entersVisiblePart();
  this->Textures.setBits(key);
}

Fingerprint TetSource::version() const
{
  Fingerprint version = this->Volume.scalarsVersion();
  add(version, this->Volume.hiddenVersion());
  return version;
}

std::vector<BufferSize> TetSource::bufferSizes() const
{
  const MeshScalars& scalars = this->Volume.scalars();
  std::vector<BufferSize> sizes =
    tetmarch::bufferSizes(this->mesh(), scalars.OfCells.size(), this->Volume.hiddenCells().size());
  if (this->entersVisiblePart())
  {
    const VisiblePart& visible = this->Volume.visiblePart();
    sizes.push_back({ "faces of what is visible", visible.Faces.size(), sizeof(visible.Faces[0]) });
  }
  if (const std::size_t count = scalars.Further.count())
  {
    sizes.push_back({ "further scalars", scalars.Further.Values.size() / count,
      MeshTextures::furtherScalarsOfTexel(count) * sizeof(float),
      scalars.OfCells.empty() ? 1 : MostCellBuffers });
  }
  return sizes;
}

bool TetSource::isUploaded() const
{
  return this->Links.holds(this->Volume.linksVersion()) &&
         this->Scalars.holds(this->Volume.scalarsVersion()) &&
         this->HiddenCells.holds(this->Volume.hiddenVersion()) &&
         this->VisibleTets.holds(this->Volume.visibleVersion());
}

std::string TetSource::upload(vtkOpenGLRenderWindow* window)
{
  std::string error;
  const auto update =
    [&](Uploaded& part, const Fingerprint& version, const auto& upload, const auto& bytes)
  { error = error.empty() ? part.update(version, upload, bytes) : error; };
  const TetMesh& mesh = this->mesh();
  const MeshScalars& scalars = this->Volume.scalars();
  const auto& hidden = this->Volume.hiddenCells();
  update(
    this->Links, this->Volume.linksVersion(),
    [&] { return this->Textures.uploadCells(window, mesh); },
    [&]
    {
      return sizeof(PackedCell) * mesh.Tets.size() + 16 * mesh.BoundaryFaces.size() +
             sizeof(HierarchyNode) * mesh.Hierarchy.size();
    });
  update(
    this->Scalars, this->Volume.scalarsVersion(),
    [&] { return this->Textures.uploadScalars(window, mesh, scalars); },
    [&]
    {
      return sizeof(Vertex) * mesh.Vertices.size() + sizeof(float) * scalars.OfCells.size() +
             this->Textures.furtherBytes();
    });
  update(
    this->HiddenCells, this->Volume.hiddenVersion(),
    [&] { return this->Textures.uploadHiddenCells(window, hidden); },
    [&] { return sizeof(std::uint32_t) * hidden.size(); });
  update(
    this->VisibleTets, this->Volume.visibleVersion(),
    [&]
    {
      this->Visible.release(window);
      return this->entersVisiblePart() ? this->Visible.upload(window, this->Volume.visiblePart())
                                       : std::string();
    },
    [&] { return this->Visible.bytes(); });
  return error;
}

void TetSource::release(vtkWindow* window)
{
  this->Textures.release(window);
  this->Entries.release(window);
  this->Visible.release(window);
  for (Uploaded* part : { &this->Links, &this->Scalars, &this->HiddenCells, &this->VisibleTets })
  {
    part->forget();
  }
}

std::string TetSource::describeBadSamples() const
{
  return "The accuracy level is Sampled, which is for images and rectilinear grids alone. Choose "
         "another one, such as SetAccuracyLevelToDefault().";
}

void TetSource::bind(vtkShaderProgram* program, const VariantKey& key)
{
  this->Textures.bind(program, key);
  if (key.EntryLists)
  {
    this->Entries.bind(program);
  }
  if (key.VisiblePart)
  {
    this->Visible.bind(program);
  }
}

void TetSource::unbind()
{
  this->Textures.unbind();
  this->Visible.unbind();
  this->Entries.unbind();
}

std::string TetSource::listEntries(vtkOpenGLRenderWindow* window, const VariantKey& key,
  const Viewport& viewport, const View& camera)
{
  Fingerprint version =
    key.VisiblePart ? this->Volume.visibleVersion() : this->Volume.linksVersion();
  add(version, key.VisiblePart ? 1 : 0);
  addAll(version, camera.NormalizedToClip);
  add(version, viewport.Width);
  add(version, viewport.Height);
  if (this->Entries.holds(version))
  {
    return {};
  }
  std::string error;
  const std::string shortage = withinMemory("the lists of entries",
    [&]
    {
      const StageRecorder recorder(this->EntriesRecord);
      const auto& faces =
        key.VisiblePart ? this->Volume.visiblePart().Faces : this->mesh().BoundaryFaces;
      const EntryLists lists = makeEntryListsWithin(
        this->Limits.TexelsPerBuffer, this->mesh(), faces, camera, viewport.Width, viewport.Height);
      error = this->Entries.upload(window, lists, version);
    });
  return shortage.empty() ? error : shortage;
}

ReferenceScene TetSource::withVolume(ReferenceScene scene) const
{
  const MeshScalars& scalars = this->Volume.scalars();
  scene.Mesh = &this->mesh();
  scene.CellScalars = scalars.OfCells.empty() ? nullptr : &scalars.OfCells;
  scene.Further = &scalars.Further;
  scene.Range = scalars.Range;
  scene.Hidden = &this->Volume.hiddenCells();
  return scene;
}

ReferenceImage TetSource::renderReference(ReferenceScene scene, const AccuracyLevel& level) const
{
  return tetmarch::renderReference<double>(this->withVolume(scene), level);
}

RayTrace TetSource::traceRay(ReferenceScene scene, const TraceOptions& options) const
{
  const ReferenceScene whole = this->withVolume(scene);
  return options.InDouble ? tetmarch::traceRay<double>(whole, options.Level, options.X, options.Y)
                          : tetmarch::traceRay<float>(whole, options.Level, options.X, options.Y);
}

} // namespace tetmarch
