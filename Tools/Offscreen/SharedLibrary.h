// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A shared library that is opened at run time and stays open until the process ends.
 */
#ifndef tetmarch_SharedLibrary_h
#define tetmarch_SharedLibrary_h

#include <dlfcn.h>
#include <initializer_list>
#include <string>

namespace tetmarch
{

class SharedLibrary
{
public:
  /// Opens the first of the names that can be opened.
  explicit SharedLibrary(std::initializer_list<const char*> names)
  {
    for (const char* name : names)
    {
      this->Handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (this->Handle)
      {
        return;
      }
      const char* reason = dlerror();
      this->Error += (this->Error.empty() ? "" : "; ") + std::string(reason ? reason : name);
    }
  }

  explicit operator bool() const { return this->Handle != nullptr; }
  const std::string& GetError() const { return this->Error; }

  template <typename Function>
  bool Find(const char* name, Function& function) const
  {
    function = reinterpret_cast<Function>(this->Handle ? dlsym(this->Handle, name) : nullptr);
    return function != nullptr;
  }

private:
  void* Handle = nullptr;
  std::string Error;
};

} // namespace tetmarch

#endif
