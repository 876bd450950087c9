// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An array on the GPU that exists as long as something needs it, and is uploaded again when it
// changed: in a TextureBuffer or a CellBuffer.
#ifndef TetMarchGLVersionedBuffer_h
#define TetMarchGLVersionedBuffer_h

#include "Caching/Fingerprint.h"
#include "GL/TextureBuffer.h"

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
    vtkOpenGLRenderWindow* window, bool needed, const Fingerprint& version, Upload&& upload)
  {
    if (!needed || version != this->Version)
    {
      this->release(window);
    }
    std::string error;
    if (needed && this->Buffer.bytes() == 0)
    {
      error = upload(this->Buffer);
      if (error.empty())
      {
        this->Version = version;
        this->UploadedBytes += static_cast<std::int64_t>(this->Buffer.bytes());
      }
    }
    return error;
  }
  /** Whether update() has nothing to do. */
  bool isCurrent(bool needed, const Fingerprint& version) const
  {
    return needed ? this->bytes() > 0 && version == this->Version : this->bytes() == 0;
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
    this->Version.clear();
  }
  std::size_t bytes() const { return this->Buffer.bytes(); }
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const { return this->UploadedBytes; }

private:
  BufferType Buffer;
  Fingerprint Version;
  std::int64_t UploadedBytes = 0;
};

using VersionedBuffer = Versioned<TextureBuffer>;

} // namespace tetmarch

#endif
