// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lets functions of the GL fail
 */
#ifndef tetmarch_testing_FaultyGL_h
#define tetmarch_testing_FaultyGL_h

#include <functional>
#include <string>

namespace tetmarch::testing
{
enum class Fault
{
  CompileStatus,     ///< a shader doesn't compile, without a message
  LinkStatus,        ///< a program doesn't link
  FramebufferStatus, ///< a framebuffer is incomplete
  BufferData,        ///< no memory for a buffer
  TexBuffer,         ///< a buffer doesn't become a texture
  TexImage,          ///< no memory for a texture
  Blit               ///< a copy between framebuffers is refused
};
constexpr Fault AllFaults[] = { Fault::CompileStatus, Fault::LinkStatus, Fault::FramebufferStatus,
  Fault::BufferData, Fault::TexBuffer, Fault::TexImage, Fault::Blit };
const char* nameOf(Fault fault);

/// One at a time, as long as it lives.
class FaultyGL
{
public:
  /// The call with that number fails, from 0 on.
  FaultyGL(Fault fault, int call);
  /// The function changes the text of each shader before it is compiled.
  explicit FaultyGL(const std::function<std::string(const std::string&)>& rewrite);
  /// The GL claims to take so many texels in a texture buffer.
  static FaultyGL withMostTexels(int texels) { return FaultyGL(texels); }
  /// And a call fails.
  FaultyGL(int mostTexels, Fault fault, int call);
  ~FaultyGL();
  FaultyGL(const FaultyGL&) = delete;
  FaultyGL& operator=(const FaultyGL&) = delete;

  /// Whether anything has failed.
  bool happened() const;

private:
  explicit FaultyGL(int mostTexels);
};
} // namespace tetmarch::testing

#endif
