// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a volume on the GPU, and the lists of where rays may enter them.
#ifndef TetMarchGLTetTextures_h
#define TetMarchGLTetTextures_h

#include "Caching/StageRecord.h"
#include "Entries/EntryListMaker.h"
#include "GL/EntryListTextures.h"
#include "GL/MeshTextures.h"
#include "GL/Uploaded.h"
#include "GL/VisiblePartTextures.h"
#include "GL/VolumeTextures.h"

#include <array>

namespace tetmarch
{

class TetVolume;

class TetTextures : public VolumeTextures
{
public:
  /** The volume lives longer than the textures. */
  explicit TetTextures(const TetVolume& volume)
    : Volume(volume)
  {
  }

  std::vector<BufferSize> bufferSizes() const override;
  bool isCurrent() const override;
  std::string upload(vtkOpenGLRenderWindow* window) override;
  void release(vtkWindow* window) override;
  std::size_t bytes() const override
  {
    return this->Mesh.bytes() + this->Visible.bytes() + this->Entries[0].bytes() +
           this->Entries[1].bytes();
  }
  std::int64_t uploadedBytes() const override
  {
    return this->Links.allBytes() + this->Scalars.allBytes() + this->HiddenCells.allBytes() +
           this->EnteredTets.allBytes();
  }

  void setBits(VariantKey& key) const override { this->Mesh.setBits(key); }
  void bind(vtkShaderProgram* program, const VariantKey& key) override;
  void unbind() override;

  std::string listEntries(vtkOpenGLRenderWindow* window, const VariantKey& key,
    const Viewport& viewport, const View& camera) override;
  void releaseEntries(vtkWindow* window) override;
  Viewport enteredPart(const VariantKey& key, const Viewport& target) const override
  {
    return key.EntryLists ? this->Entries[this->Eye].enteredPart(target) : target;
  }
  const StageRecord& entriesRecord() const { return this->EntriesRecord; }

private:
  void chooseEntries(vtkOpenGLRenderWindow* window, const Fingerprint& version);

  const TetVolume& Volume;
  MeshTextures Mesh;
  Uploaded Links;
  Uploaded Scalars;
  Uploaded HiddenCells;
  Uploaded EnteredTets;
  VisiblePartTextures Visible;
  EntryListMaker ListMaker;
  std::array<EntryListTextures, 2> Entries; // of both eyes of a stereo picture
  std::size_t Eye = 0;                      // whose lists are in use
  StageRecord EntriesRecord;
};

} // namespace tetmarch

#endif
