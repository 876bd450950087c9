// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The integral table on the GPU.
#ifndef TetMarchGLTableTextures_h
#define TetMarchGLTableTextures_h

#include "Appearance/Components.h"
#include "GL/TextureBuffer.h"
#include "Mesh/Scalars.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Variants/VariantKey.h"

namespace tetmarch
{

class TableTextures
{
public:
  /** With those of further components behind it, if there are. Returns an empty string, or what is
   * wrong. */
  std::string upload(
    vtkOpenGLRenderWindow* window, const IntegralTable& table, const Components& components);
  void bind(vtkShaderProgram* program, const IntegralTable& table, const ScalarRange& range,
    const Components& components, const AccuracyLevel& level, const VariantKey& key);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;

private:
  std::string uploadSeveral(
    vtkOpenGLRenderWindow* window, const IntegralTable& table, const Components& components);

  TextureBuffer Values;
  TextureBuffer Integrals;
  TextureBuffer Variations;
};

} // namespace tetmarch

#endif
