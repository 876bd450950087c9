// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Values of a lattice on the GPU: a texture of layers, of which a shader reads four values at once.
// vtkTextureObject makes none of that kind.
#ifndef TetMarchGLArrayTexture_h
#define TetMarchGLArrayTexture_h

#include "Structured/StoredValues.h"

#include "vtkWeakPointer.h"

#include <array>
#include <cstddef>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace tetmarch
{

class ArrayTexture
{
public:
  ArrayTexture() = default;
  ArrayTexture(const ArrayTexture&) = delete;
  ArrayTexture& operator=(const ArrayTexture&) = delete;

  /** Replace the contents: width, height and number of layers, which the GL takes. False if it has
   * no room for them. */
  bool upload(vtkOpenGLRenderWindow* window, const std::array<int, 3>& sizes, ValueType type,
    const void* values);
  /** Bind to a sampler of the program that is in use. */
  void bind(vtkShaderProgram* program, const char* sampler);
  /** Bind to a texture unit, and return which. */
  int activate();
  void unbind();
  /** The window's context is current. */
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Bytes; }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned int Handle = 0;
  int Unit = -1;
  std::size_t Bytes = 0;
};

/** The greatest width, height and number of layers in the current context. */
std::array<int, 3> mostLayers();

/** How many layers of that width and height a texture takes in the current context: all of them,
 * or fewer if the GL says so. */
int layersTaken(const std::array<int, 3>& sizes, ValueType type);

} // namespace tetmarch

#endif
