// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/GpuData.h"

namespace tetmarch
{

std::string GpuData::upload(vtkOpenGLRenderWindow* window, const TetMesh& mesh,
  const std::vector<float>& cellScalars, const HiddenCells& hidden, const IntegralTable& table,
  const Components& components)
{
  std::string error;
  if (!this->HasLinks)
  {
    error = this->Mesh.uploadLinks(window, mesh);
    this->HasLinks = error.empty();
    this->UploadedBytes +=
      static_cast<std::int64_t>(sizeof(Link) * mesh.Links.size() + 16 * mesh.BoundaryFaces.size() +
                                sizeof(HierarchyNode) * mesh.Hierarchy.size());
  }
  if (error.empty() && !this->HasScalars)
  {
    error = this->Mesh.uploadVertices(window, mesh);
    if (error.empty())
    {
      error = this->Mesh.uploadCellScalars(window, cellScalars);
    }
    if (error.empty())
    {
      error = this->Mesh.uploadFurtherScalars(window, components.Further);
    }
    this->HasScalars = error.empty();
    this->UploadedBytes +=
      static_cast<std::int64_t>(sizeof(Vertex) * mesh.Vertices.size() +
                                sizeof(float) * cellScalars.size() + this->Mesh.furtherBytes());
  }
  if (error.empty() && !this->HasHiddenCells)
  {
    error = this->Mesh.uploadHiddenCells(window, hidden);
    this->HasHiddenCells = error.empty();
    this->UploadedBytes += static_cast<std::int64_t>(sizeof(std::uint32_t) * hidden.size());
  }
  if (error.empty() && !this->HasTables)
  {
    error = this->Tables.upload(window, table, components);
    this->HasTables = error.empty();
    this->UploadedBytes += static_cast<std::int64_t>(this->Tables.bytes());
  }
  return error;
}

void GpuData::release(vtkWindow* window)
{
  this->Mesh.release(window);
  this->Tables.release(window);
  this->HasLinks = this->HasScalars = this->HasHiddenCells = this->HasTables = false;
}

} // namespace tetmarch
