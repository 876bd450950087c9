// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/MeshTextures.h"

#include "Mesh/TetMesh.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace tetmarch
{
namespace
{

static_assert(sizeof(Vertex) == 16 && sizeof(Link) == 8 && sizeof(HierarchyNode) == 32,
  "arrays are uploaded as they are");

// Before anything is allocated: does the GL take so many texels?
std::string checkSize(const char* what, std::size_t texels)
{
  const std::size_t most = mostTexels();
  return texels <= most
           ? std::string()
           : std::string("The mesh is too large for this GL: it needs ") + std::to_string(texels) +
               " texels for its " + what + ", the GL takes " + std::to_string(most) +
               " (GL_MAX_TEXTURE_BUFFER_SIZE). Extract or coarsen a part of the grid.";
}

} // namespace

std::string MeshTextures::uploadLinks(vtkOpenGLRenderWindow* window, const TetMesh& mesh)
{
  std::string error = checkSize("links", mesh.Links.size());
  if (error.empty())
  {
    error = checkSize("vertices", mesh.Vertices.size());
  }
  if (error.empty())
  {
    error = this->Links.upload(window, TexelFormat::RG32UI, mesh.Links.data(), mesh.Links.size());
  }
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
  return error;
}

std::string MeshTextures::uploadVertices(vtkOpenGLRenderWindow* window, const TetMesh& mesh)
{
  return this->Vertices.upload(
    window, TexelFormat::RGBA32F, mesh.Vertices.data(), mesh.Vertices.size());
}

std::string MeshTextures::uploadCellScalars(
  vtkOpenGLRenderWindow* window, const std::vector<float>& scalars)
{
  if (scalars.empty())
  {
    this->CellScalars.release(window);
    return {};
  }
  return this->CellScalars.upload(window, TexelFormat::R32F, scalars.data(), scalars.size());
}

void MeshTextures::bind(vtkShaderProgram* program, const VariantKey& key)
{
  this->bindBoundary(program);
  this->Links.bind(program, "linkBuffer");
  program->SetUniformi("numberOfTets", this->NumberOfTets);
  // A ray passes a tetrahedron once, or twice where the mesh is folded onto itself: once from each
  // end of its way. More means that something is wrong.
  program->SetUniformi("mostCells", 2 * this->NumberOfTets + 1);
  if (key.Hierarchy)
  {
    this->Hierarchy.bind(program, "hierarchyBuffer");
    program->SetUniformi("bvhNodeCount", this->NumberOfNodes);
    program->SetUniformi("bvhReentryNodeCount", this->NumberOfReentryNodes);
  }
  if (!key.PointScalars)
  {
    this->CellScalars.bind(program, "cellScalarBuffer");
  }
}

void MeshTextures::bindBoundary(vtkShaderProgram* program)
{
  this->Vertices.bind(program, "vertexBuffer");
  this->Boundary.bind(program, "boundaryBuffer");
}

void MeshTextures::unbind()
{
  for (TextureBuffer* buffer :
    { &this->Links, &this->Boundary, &this->Hierarchy, &this->Vertices, &this->CellScalars })
  {
    buffer->unbind();
  }
}

void MeshTextures::release(vtkWindow* window)
{
  for (TextureBuffer* buffer :
    { &this->Links, &this->Boundary, &this->Hierarchy, &this->Vertices, &this->CellScalars })
  {
    buffer->release(window);
  }
}

std::size_t MeshTextures::bytes() const
{
  return this->Links.bytes() + this->Boundary.bytes() + this->Hierarchy.bytes() +
         this->Vertices.bytes() + this->CellScalars.bytes();
}

} // namespace tetmarch
