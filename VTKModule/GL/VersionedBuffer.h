// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An array on the GPU that exists as long as something needs it, and is uploaded again when it
// changed: in a TextureBuffer or a CellBuffer.
#ifndef TetMarchGLVersionedBuffer_h
#define TetMarchGLVersionedBuffer_h

#include "GL/TextureBuffer.h"
#include "GL/Uploaded.h"

#include "vtkOpenGLRenderWindow.h"

#include <cstdint>

namespace tetmarch
{

template <typename BufferType>
class Versioned
{
public:
  /** Call `upload` if the array is needed and this version isn't on the GPU. It fills the buffer
   * and returns an empty string, or what is wrong. */
  template <typename Upload>
  std::string update(
    vtkOpenGLRenderWindow* window, bool needed, const Fingerprint& version, const Upload& upload)
  {
    if (!this->isCurrent(needed, version))
    {
      this->release(window);
    }
    return needed ? this->There.update(
                      version, [&] { return upload(this->Buffer); },
                      [&] { return this->Buffer.bytes(); })
                  : std::string();
  }
  /** Whether update() has nothing to do. */
  bool isCurrent(bool needed, const Fingerprint& version) const
  {
    return needed ? this->There.holds(version) : this->bytes() == 0;
  }
  template <typename... Samplers>
  void bind(vtkShaderProgram* program, Samplers... samplers)
  {
    this->Buffer.bind(program, samplers...);
  }
  void unbind() { this->Buffer.unbind(); }
  void release(vtkWindow* window)
  {
    this->Buffer.release(window);
    this->There.forget();
  }
  std::size_t bytes() const { return this->Buffer.bytes(); }
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const { return this->There.allBytes(); }

private:
  BufferType Buffer;
  Uploaded There;
};

using VersionedBuffer = Versioned<TextureBuffer>;

} // namespace tetmarch

#endif
