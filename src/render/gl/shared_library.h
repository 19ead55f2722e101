#pragma once

#include <dlfcn.h>

#include <span>
#include <string>

#include "tumble/sim/result.h"

namespace tumble::render {

/// A library that is loaded at run time. The library stays loaded until the process ends, because drivers leave threads
/// running.
class SharedLibrary {
 public:
  /// Loads the first of `names` that exists. Errors (kCannotFinish): none does; the message is of the first name.
  static Result<SharedLibrary> load(std::span<const char* const> names) {
    std::string first;
    for (const char* name : names) {
      void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (handle != nullptr) return SharedLibrary(handle);
      if (first.empty()) first = dlerror();
    }
    return cannot_finish(first);
  }

  /// A function of the library, null without one of that name.
  template <class Function>
  [[nodiscard]] Function find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(handle_, name));
  }

 private:
  explicit SharedLibrary(void* handle) : handle_(handle) {}
  void* handle_;
};

}  // namespace tumble::render
