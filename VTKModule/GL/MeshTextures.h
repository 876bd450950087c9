// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh and its scalars on the GPU.
#ifndef TetMarchGLMeshTextures_h
#define TetMarchGLMeshTextures_h

#include "GL/CellBuffer.h"
#include "Mesh/HiddenCells.h"
#include "Mesh/MeshScalars.h"
#include "Variants/VariantKey.h"

#include <string>
#include <vector>

namespace tetmarch
{

class MeshTextures
{
public:
  /** Each returns an empty string, or what is wrong and what to do. */
  std::string uploadCells(vtkOpenGLRenderWindow* window, const TetMesh& mesh);
  /** Vertices with their scalars, cell scalars and extra scalars. Buffers of what is not drawn
   * are freed. */
  std::string uploadScalars(
    vtkOpenGLRenderWindow* window, const TetMesh& mesh, const MeshScalars& scalars);
  /** Empty: no cell is hidden, and the buffer is freed. */
  std::string uploadHiddenCells(vtkOpenGLRenderWindow* window, const HiddenCells& hidden);

  /** Of what is uploaded. */
  void setBits(VariantKey& key) const { key.SplitCells = this->Cells.isSplit(); }

  /** Bind the buffers and sizes that the march needs; the entry pass needs bindBoundary() only. */
  void bind(vtkShaderProgram* program, const VariantKey& key);
  void bindBoundary(vtkShaderProgram* program);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;
  std::size_t cellBytes() const;
  std::size_t scalarBytes() const;
  /** The number of floats of a texel for `count` extra scalars: OpenGL 3.2 has no buffer texels of
   * three floats. */
  static std::size_t extraScalarsOfTexel(std::size_t count) { return count < 3 ? count : 4; }

private:
  std::string uploadTets(vtkOpenGLRenderWindow* window, const TetMesh& mesh);
  std::string uploadCurvilinear(vtkOpenGLRenderWindow* window, const CurvilinearCells& cells);
  std::string uploadValues(
    vtkOpenGLRenderWindow* window, const TetMesh& mesh, const MeshScalars& scalars);
  void bindCells(vtkShaderProgram* program, const VariantKey& key);
  std::string uploadCellScalars(vtkOpenGLRenderWindow* window, const std::vector<float>& scalars);
  std::string uploadCornerScalars(
    vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& scalars);
  std::string uploadExtraScalars(vtkOpenGLRenderWindow* window, const ExtraScalars& extra);

  CellBuffer Cells;
  TextureBuffer Boundary;
  TextureBuffer BoundaryOrder; // of a curvilinear grid
  TextureBuffer Hierarchy;
  TextureBuffer Vertices;
  CellBuffer CellScalars;
  CellBuffer CornerScalars;
  CellBuffer Extra;
  TextureBuffer HiddenCellBits;
  std::array<int, 9> HexahedraCounts{}; // Shaders/tet/curvilinear_buffers.glsl
  std::array<int, 9> JoinedSides{};
  int NumberOfTets = 0;
  int NumberOfNodes = 0;
  int NumberOfReentryNodes = 0;
  int NumberOfReentryFaces = 0;
};

} // namespace tetmarch

#endif
