// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of the transfer functions on the GPU.
#ifndef TetMarchGLTableTextures_h
#define TetMarchGLTableTextures_h

#include "Appearance/TransferTables.h"
#include "GL/TextureBuffer.h"
#include "GL/Uploaded.h"

namespace tetmarch
{

struct MarchInputs;

class TableTextures
{
public:
  /** Whether the tables of this run are on the GPU. */
  bool holds(const TransferTables& tables) const { return this->There.holds(versionOf(tables)); }
  /** Unless holds(): upload the table of the first scalar, and those of extra components behind
   * it. Returns an empty string, or what is wrong. */
  std::string upload(vtkOpenGLRenderWindow* window, const TransferTables& tables);
  void bind(vtkShaderProgram* program, const MarchInputs& inputs);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const { return this->There.allBytes(); }

private:
  static Fingerprint versionOf(const TransferTables& tables)
  {
    return { static_cast<std::uintptr_t>(tables.record().Runs) };
  }
  std::string uploadFirst(vtkOpenGLRenderWindow* window, const IntegralTable& table);
  std::string uploadSeveral(
    vtkOpenGLRenderWindow* window, const IntegralTable& table, const Components& components);

  TextureBuffer Values;
  TextureBuffer Integrals;
  TextureBuffer Variations;
  Uploaded There;
};

} // namespace tetmarch

#endif
