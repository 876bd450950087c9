// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TetTextures.h"

#include "Caching/WithinMemory.h"
#include "Mesh/MeshSizes.h"
#include "View/View.h"
#include "Volume/TetVolume.h"

#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{

std::vector<BufferSize> TetTextures::bufferSizes() const
{
  const MeshScalars& scalars = this->Volume.scalars();
  const std::size_t shared =
    this->Volume.mesh().Curvilinear && !scalars.OfCells.empty() ? CurvilinearCells::TetsOfCell : 1;
  std::vector<BufferSize> sizes = tetmarch::bufferSizes(
    this->Volume.mesh(), scalars.OfCells.size() / shared, this->Volume.hiddenCells().size());
  if (this->Volume.entersPart())
  {
    const auto& faces = this->Volume.enteredPart().Faces;
    sizes.push_back({ "faces of what is visible", faces.size() + MostEyeFaces, sizeof(faces[0]) });
  }
  if (!scalars.OfCorners.empty())
  {
    sizes.push_back({ "scalars of corners", scalars.OfCorners.size(), sizeof(scalars.OfCorners[0]),
      MostCellBuffers });
  }
  if (const std::size_t count = scalars.Extra.count())
  {
    sizes.push_back({ "extra scalars", scalars.Extra.Values.size() / count / shared,
      MeshTextures::extraScalarsOfTexel(count) * sizeof(float),
      scalars.OfCells.empty() ? 1 : MostCellBuffers });
  }
  return sizes;
}

bool TetTextures::isCurrent() const
{
  return this->Links.holds(this->Volume.linksVersion()) &&
         this->Scalars.holds(this->Volume.scalarsVersion()) &&
         this->HiddenCells.holds(this->Volume.hiddenVersion()) &&
         this->EnteredTets.holds(this->Volume.enteredVersion());
}

std::string TetTextures::upload(vtkOpenGLRenderWindow* window)
{
  std::string error;
  const auto update =
    [&](Uploaded& part, const Fingerprint& version, const auto& upload, const auto& bytes)
  { error = error.empty() ? part.update(version, upload, bytes) : error; };
  const TetMesh& mesh = this->Volume.mesh();
  const MeshScalars& scalars = this->Volume.scalars();
  const auto& hidden = this->Volume.hiddenCells();
  update(
    this->Links, this->Volume.linksVersion(), [&] { return this->Mesh.uploadCells(window, mesh); },
    [&] { return this->Mesh.cellBytes(); });
  update(
    this->Scalars, this->Volume.scalarsVersion(),
    [&] { return this->Mesh.uploadScalars(window, mesh, scalars); },
    [&] { return this->Mesh.scalarBytes(); });
  update(
    this->HiddenCells, this->Volume.hiddenVersion(),
    [&] { return this->Mesh.uploadHiddenCells(window, hidden); },
    [&] { return sizeof(std::uint32_t) * hidden.size(); });
  update(
    this->EnteredTets, this->Volume.enteredVersion(),
    [&]
    {
      this->Visible.release(window);
      return this->Volume.entersPart() ? this->Visible.upload(window, this->Volume.enteredPart(),
                                           this->Volume.startsAtEye())
                                       : std::string();
    },
    [&] { return this->Visible.bytes(); });
  return error;
}

void TetTextures::release(vtkWindow* window)
{
  this->Mesh.release(window);
  this->releaseEntries(window);
  this->Visible.release(window);
  for (Uploaded* part : { &this->Links, &this->Scalars, &this->HiddenCells, &this->EnteredTets })
  {
    part->forget();
  }
}

void TetTextures::bind(vtkShaderProgram* program, const VariantKey& key)
{
  this->Mesh.bind(program, key);
  if (key.EntryLists)
  {
    this->Entries[this->Eye].bind(program);
  }
  if (key.VisiblePart)
  {
    this->Visible.bind(program);
  }
}

void TetTextures::unbind()
{
  this->Mesh.unbind();
  this->Visible.unbind();
  this->Entries[this->Eye].unbind();
}

void TetTextures::releaseEntries(vtkWindow* window)
{
  this->ListMaker = {};
  for (EntryListTextures& entries : this->Entries)
  {
    entries.release(window);
  }
}

// A stereo picture has two views by turns: the lists of both are kept.
void TetTextures::chooseEntries(vtkOpenGLRenderWindow* window, const Fingerprint& version)
{
  const int type = window->GetStereoType();
  const bool oneEye =
    !window->GetStereoRender() || type == VTK_STEREO_LEFT || type == VTK_STEREO_RIGHT;
  const std::size_t other = 1 - this->Eye;
  if (oneEye)
  {
    this->Entries[other].release(window);
  }
  else if (!this->Entries[this->Eye].holds(version))
  {
    this->Eye = other;
  }
}

std::string TetTextures::listEntries(vtkOpenGLRenderWindow* window, const VariantKey& key,
  const Viewport& viewport, const View& camera)
{
  // Only the part has faces around the eye.
  const bool startsAtEye = key.VisiblePart && this->Volume.startsAtEye();
  if (startsAtEye)
  {
    this->Visible.replaceEyeFaces(this->Volume.eyeStart());
  }
  Fingerprint version =
    key.VisiblePart ? this->Volume.enteredVersion() : this->Volume.linksVersion();
  add(version, key.VisiblePart ? 1 : 0);
  add(version, startsAtEye ? 1 : 0);
  addAll(version, camera.NormalizedToClip);
  add(version, viewport.Width);
  add(version, viewport.Height);
  this->chooseEntries(window, version);
  EntryListTextures& entries = this->Entries[this->Eye];
  if (entries.holds(version))
  {
    return {};
  }
  std::string error;
  const std::string shortage = withinMemory("the lists of entries",
    [&]
    {
      const StageRecorder recorder(this->EntriesRecord);
      const auto& faces =
        key.VisiblePart ? this->Volume.enteredPart().Faces : this->Volume.mesh().BoundaryFaces;
      const EntryLists& lists = this->ListMaker.make(this->Volume.limits().TexelsPerBuffer,
        this->Volume.mesh(), faces, camera, viewport.Width, viewport.Height,
        startsAtEye ? this->Volume.eyeStart() : EyeStart());
      error = entries.upload(window, lists, version);
    });
  return shortage.empty() ? error : shortage;
}

} // namespace tetmarch
