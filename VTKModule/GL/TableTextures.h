// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of the transfer functions on the GPU.
#ifndef TetMarchGLTableTextures_h
#define TetMarchGLTableTextures_h

#include "Appearance/TransferTables.h"
#include "GL/TextureBuffer.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"
#include "Variants/VariantKey.h"

namespace tetmarch
{

class TableTextures
{
public:
  /** Whether the tables of this run are on the GPU. */
  bool holds(const TransferTables& tables) const { return this->Run == tables.record().Runs; }
  /** Unless holds(): upload the table of the first scalar, and those of further components behind
   * it. Returns an empty string, or what is wrong. */
  std::string upload(vtkOpenGLRenderWindow* window, const TransferTables& tables);
  void bind(vtkShaderProgram* program, const IntegralTable& table, const ScalarRange& range,
    const Components& components, const AccuracyLevel& level, const VariantKey& key);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const { return this->UploadedBytes; }

private:
  std::string uploadFirst(vtkOpenGLRenderWindow* window, const IntegralTable& table);
  std::string uploadSeveral(
    vtkOpenGLRenderWindow* window, const IntegralTable& table, const Components& components);

  TextureBuffer Values;
  TextureBuffer Integrals;
  TextureBuffer Variations;
  std::int64_t Run = 0; // of the tables that are on the GPU; 0: none
  std::int64_t UploadedBytes = 0;
};

} // namespace tetmarch

#endif
