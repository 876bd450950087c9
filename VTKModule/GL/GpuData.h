// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh, its scalars and the tables on the GPU, of which only what changed is uploaded.
#ifndef TetMarchGLGpuData_h
#define TetMarchGLGpuData_h

#include "GL/MeshTextures.h"
#include "GL/TableTextures.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetmarch
{

class GpuData
{
public:
  /** What the next upload() has to replace. */
  void expectMesh() { this->HasLinks = this->HasScalars = this->HasHiddenCells = false; }
  void expectLinks() { this->HasLinks = false; }
  void expectScalars() { this->HasScalars = false; }
  void expectHiddenCells() { this->HasHiddenCells = false; }
  void expectTables() { this->HasTables = false; }

  bool isCurrent() const
  {
    return this->HasLinks && this->HasScalars && this->HasHiddenCells && this->HasTables;
  }
  /** Returns an empty string, or what is wrong; what did not get there is tried again next time. */
  std::string upload(vtkOpenGLRenderWindow* window, const TetMesh& mesh,
    const std::vector<float>& cellScalars, const HiddenCells& hidden, const IntegralTable& table,
    const Components& components);
  void release(vtkWindow* window);

  MeshTextures& mesh() { return this->Mesh; }
  TableTextures& tables() { return this->Tables; }
  std::size_t bytes() const { return this->Mesh.bytes() + this->Tables.bytes(); }
  /** Ever. */
  std::int64_t uploadedBytes() const { return this->UploadedBytes; }

private:
  bool HasLinks = false;
  bool HasScalars = false;
  bool HasHiddenCells = false;
  bool HasTables = false;
  MeshTextures Mesh;
  TableTextures Tables;
  std::int64_t UploadedBytes = 0;
};

} // namespace tetmarch

#endif
