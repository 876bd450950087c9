// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/MeshTextures.h"

#include "Mesh/PackedCells.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

static_assert(sizeof(Vertex) == 16 && sizeof(PackedCell) == 16 && sizeof(HierarchyNode) == 32,
  "arrays are uploaded as they are");

// Of each cell of a curvilinear grid, whose tetrahedra have equal scalars.
MeshScalars scalarsOfCells(const MeshScalars& scalars)
{
  MeshScalars ofCells;
  const std::size_t count = scalars.Extra.count();
  ofCells.Extra.Ranges = scalars.Extra.Ranges;
  for (std::size_t t = 0; t < scalars.OfCells.size(); t += CurvilinearCells::TetsOfCell)
  {
    ofCells.OfCells.push_back(scalars.OfCells[t]);
    const auto first = scalars.Extra.Values.begin() + static_cast<std::ptrdiff_t>(count * t);
    ofCells.Extra.Values.insert(
      ofCells.Extra.Values.end(), first, first + static_cast<std::ptrdiff_t>(count));
  }
  return ofCells;
}

} // namespace

std::string MeshTextures::uploadCells(vtkOpenGLRenderWindow* window, const TetMesh& mesh)
{
  std::string error = mesh.Curvilinear ? this->uploadCurvilinear(window, *mesh.Curvilinear)
                                       : this->uploadTets(window, mesh);
  if (error.empty())
  {
    error = this->Boundary.upload(
      window, TexelFormat::RGBA32UI, mesh.BoundaryFaces.data(), mesh.BoundaryFaces.size());
  }
  this->Hierarchy.release(window);
  if (error.empty() && mesh.hasHierarchy())
  {
    error = this->Hierarchy.upload(
      window, TexelFormat::RGBA32F, mesh.Hierarchy.data(), 2 * mesh.Hierarchy.size());
  }
  this->NumberOfTets = static_cast<int>(mesh.numberOfTets());
  this->NumberOfNodes = static_cast<int>(mesh.Hierarchy.size());
  this->NumberOfReentryNodes = static_cast<int>(mesh.ReentryNodes);
  this->NumberOfReentryFaces = static_cast<int>(mesh.ReentryFaces);
  return error;
}

std::string MeshTextures::uploadTets(vtkOpenGLRenderWindow* window, const TetMesh& mesh)
{
  this->BoundaryOrder.release(window);
  std::vector<PackedCell> cells;
  return this->Cells.upload(window, TexelFormat::RGBA32UI, mesh.Tets.size(),
    [&](std::size_t begin, std::size_t end)
    {
      packCells(mesh, begin, end, cells);
      return cells.data();
    });
}

std::string MeshTextures::uploadCurvilinear(
  vtkOpenGLRenderWindow* window, const CurvilinearCells& cells)
{
  this->Cells.release(window);
  std::copy_n(cells.cells().begin(), 3, this->HexahedraCounts.begin());
  std::copy_n(cells.firstFaces().begin(), 6, this->HexahedraCounts.begin() + 3);
  std::copy_n(cells.joins().Rings.begin(), 3, this->JoinedSides.begin());
  std::copy_n(cells.joins().Poles.begin(), 6, this->JoinedSides.begin() + 3);
  return this->BoundaryOrder.upload(
    window, TexelFormat::R32UI, cells.order().data(), cells.order().size());
}

void MeshTextures::bindCells(vtkShaderProgram* program, const VariantKey& key)
{
  if (!key.Curvilinear)
  {
    this->Cells.bind(program, "cellBuffer", "secondCellBuffer");
    return;
  }
  const std::array<int, 9>& counts = this->HexahedraCounts;
  const std::array<float, 2> shares{ { 1.0f / static_cast<float>(counts[0]),
    1.0f / static_cast<float>(counts[1]) } };
  if (key.Hierarchy)
  {
    this->BoundaryOrder.bind(program, "boundaryOrderBuffer");
  }
  program->SetUniform1iv("hexahedraCounts", static_cast<int>(counts.size()), counts.data());
  program->SetUniform2f("hexahedraShares", shares.data());
  if (key.JoinedSides)
  {
    program->SetUniform1iv(
      "joinedSides", static_cast<int>(this->JoinedSides.size()), this->JoinedSides.data());
  }
}

std::string MeshTextures::uploadScalars(
  vtkOpenGLRenderWindow* window, const TetMesh& mesh, const MeshScalars& scalars)
{
  if (mesh.Curvilinear && !scalars.OfCells.empty())
  {
    return this->uploadValues(window, mesh, scalarsOfCells(scalars));
  }
  return this->uploadValues(window, mesh, scalars);
}

std::string MeshTextures::uploadValues(
  vtkOpenGLRenderWindow* window, const TetMesh& mesh, const MeshScalars& scalars)
{
  std::string error =
    this->Vertices.upload(window, TexelFormat::RGBA32F, mesh.Vertices.data(), mesh.Vertices.size());
  if (error.empty())
  {
    error = this->uploadCellScalars(window, scalars.OfCells);
  }
  error = error.empty() ? this->uploadCornerScalars(window, scalars.OfCorners) : error;
  return error.empty() ? this->uploadExtraScalars(window, scalars.Extra) : error;
}

std::string MeshTextures::uploadCellScalars(
  vtkOpenGLRenderWindow* window, const std::vector<float>& scalars)
{
  if (scalars.empty())
  {
    this->CellScalars.release(window);
    return {};
  }
  return this->CellScalars.upload(window, TexelFormat::R32F, scalars.size(),
    [&](std::size_t begin, std::size_t) { return &scalars[begin]; });
}

std::string MeshTextures::uploadCornerScalars(
  vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& scalars)
{
  if (scalars.empty())
  {
    this->CornerScalars.release(window);
    return {};
  }
  return this->CornerScalars.upload(window, TexelFormat::RGBA32F, scalars.size(),
    [&](std::size_t begin, std::size_t) { return &scalars[begin]; });
}

std::string MeshTextures::uploadExtraScalars(
  vtkOpenGLRenderWindow* window, const ExtraScalars& extra)
{
  const std::vector<float>& values = extra.Values;
  const std::size_t count = extra.count();
  if (count == 0)
  {
    this->Extra.release(window);
    return {};
  }
  if (count < 3)
  {
    return this->Extra.upload(window, count == 1 ? TexelFormat::R32F : TexelFormat::RG32F,
      values.size() / count,
      [&](std::size_t begin, std::size_t) { return &values[count * begin]; });
  }
  std::vector<std::array<float, 4>> texels;
  return this->Extra.upload(window, TexelFormat::RGBA32F, values.size() / 3,
    [&](std::size_t begin, std::size_t end)
    {
      texels.resize(end - begin);
      for (std::size_t i = 0; i < texels.size(); ++i)
      {
        const float* value = &values[3 * (begin + i)];
        texels[i] = { { value[0], value[1], value[2], 0.0f } };
      }
      return texels.data();
    });
}

std::string MeshTextures::uploadHiddenCells(
  vtkOpenGLRenderWindow* window, const HiddenCells& hidden)
{
  if (hidden.empty())
  {
    this->HiddenCellBits.release(window);
    return {};
  }
  return this->HiddenCellBits.upload(window, TexelFormat::R32UI, hidden.data(), hidden.size());
}

void MeshTextures::bind(vtkShaderProgram* program, const VariantKey& key)
{
  this->bindBoundary(program);
  this->bindCells(program, key);
  program->SetUniformi("numberOfTets", this->NumberOfTets);
  program->SetUniformi("mostSteps", mostCellsOf(this->NumberOfTets));
  if (key.SplitCells)
  {
    program->SetUniformi("cellsOfFirstBuffer", static_cast<int>(this->Cells.texelsOfFirst()));
  }
  if (key.Hierarchy)
  {
    this->Hierarchy.bind(program, "hierarchyBuffer");
    program->SetUniformi("bvhNodeCount", this->NumberOfNodes);
    program->SetUniformi("bvhReentryNodeCount", this->NumberOfReentryNodes);
    program->SetUniformi("reentryFaceCount", this->NumberOfReentryFaces);
  }
  if (!key.PointScalars)
  {
    this->CellScalars.bind(program, "cellScalarBuffer", "secondCellScalarBuffer");
  }
  if (key.CornerScalars)
  {
    this->CornerScalars.bind(program, "cornerScalarBuffer", "secondCornerScalarBuffer");
  }
  if (key.hasComponents())
  {
    this->Extra.bind(program, "extraScalarBuffer", "secondExtraScalarBuffer");
  }
  if (key.HiddenCells)
  {
    this->HiddenCellBits.bind(program, "hiddenCellBuffer");
  }
}

void MeshTextures::bindBoundary(vtkShaderProgram* program)
{
  this->Vertices.bind(program, "vertexBuffer");
  this->Boundary.bind(program, "boundaryBuffer");
}

void MeshTextures::unbind()
{
  for (CellBuffer* buffer :
    { &this->Cells, &this->CellScalars, &this->CornerScalars, &this->Extra })
  {
    buffer->unbind();
  }
  for (TextureBuffer* buffer : { &this->Boundary, &this->BoundaryOrder, &this->Hierarchy,
         &this->Vertices, &this->HiddenCellBits })
  {
    buffer->unbind();
  }
}

void MeshTextures::release(vtkWindow* window)
{
  for (CellBuffer* buffer :
    { &this->Cells, &this->CellScalars, &this->CornerScalars, &this->Extra })
  {
    buffer->release(window);
  }
  for (TextureBuffer* buffer : { &this->Boundary, &this->BoundaryOrder, &this->Hierarchy,
         &this->Vertices, &this->HiddenCellBits })
  {
    buffer->release(window);
  }
}

std::size_t MeshTextures::cellBytes() const
{
  return this->Cells.bytes() + this->Boundary.bytes() + this->BoundaryOrder.bytes() +
         this->Hierarchy.bytes();
}

std::size_t MeshTextures::scalarBytes() const
{
  return this->Vertices.bytes() + this->CellScalars.bytes() + this->CornerScalars.bytes() +
         this->Extra.bytes();
}

std::size_t MeshTextures::bytes() const
{
  return this->cellBytes() + this->scalarBytes() + this->HiddenCellBits.bytes();
}

} // namespace tetmarch
