#pragma once

#include <dlfcn.h>

#include <span>
#include <string>

#include "src/base/result.h"

namespace tumble::render {

/// A library found at run time. It stays loaded for the life of the process: drivers leave threads behind.
class SharedLibrary {
 public:
  /// The first of `names` that is there. Errors (kCannotFinish): none is, with the loader's words on the first.
  static Result<SharedLibrary> load(std::span<const char* const> names) {
    std::string first;
    for (const char* name : names) {
      void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (handle != nullptr) return SharedLibrary(handle);
      if (first.empty()) first = dlerror();
    }
    return cannot_finish(first);
  }

  /// A function of it, null if it has none of that name.
  template <class Function>
  [[nodiscard]] Function find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(handle_, name));
  }

 private:
  explicit SharedLibrary(void* handle) : handle_(handle) {}
  void* handle_;
};

}  // namespace tumble::render
