// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dlfcn.h>
#include <fmt/format.h>

#include <memory>

#include "core/error.h"

namespace pellucid::oit {

/// A SharedLibrary is loaded at run time. It stays loaded until the process ends: Mesa keeps
/// threads that run its code.
class SharedLibrary {
 public:
  /// Loads the library. Throws WorkError when it cannot be loaded.
  explicit SharedLibrary(const char* name) : name_(name), handle_(::dlopen(name, RTLD_NOW)) {
    if (!handle_) throw WorkError(fmt::format("cannot load {}: {}", name, ::dlerror()));
  }

  /// Returns a function of the library. Throws WorkError when it has none of that name.
  template <class Function>
  Function function(const char* symbol) const {
    void* address = ::dlsym(handle_, symbol);
    if (!address) throw WorkError(fmt::format("{} has no {}", name_, symbol));
    return reinterpret_cast<Function>(address);
  }

 private:
  const char* name_;
  void* handle_;
};

}  // namespace pellucid::oit
