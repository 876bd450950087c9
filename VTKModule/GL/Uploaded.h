// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which version of something is on the GPU.
#ifndef TetMarchGLUploaded_h
#define TetMarchGLUploaded_h

#include "Caching/Fingerprint.h"

#include <optional>
#include <string>

namespace tetmarch
{

class Uploaded
{
public:
  bool holds(const Fingerprint& version) const { return this->Version == version; }
  /** Unless this version is on the GPU, call upload(), which returns an empty string, or what is
   * wrong; then nothing is there. bytes() is the size of what was uploaded. */
  template <typename Upload, typename Bytes>
  std::string update(const Fingerprint& version, const Upload& upload, const Bytes& bytes)
  {
    if (this->holds(version))
    {
      return {};
    }
    this->forget();
    std::string error = upload();
    if (error.empty())
    {
      this->Version = version;
      this->AllBytes += static_cast<std::int64_t>(bytes());
    }
    return error;
  }
  /** It was released. */
  void forget() { this->Version.reset(); }
  /** How many bytes were uploaded in all. */
  std::int64_t allBytes() const { return this->AllBytes; }

private:
  std::optional<Fingerprint> Version; // none: nothing is there
  std::int64_t AllBytes = 0;
};

} // namespace tetmarch

#endif
