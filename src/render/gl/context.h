#pragma once

#include <memory>
#include <string>

#include "src/render/gl/table.h"
#include "tumble/render/backend.h"
#include "tumble/render/window.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// An OpenGL 3.3 core context, current on the thread that opened it: without window or display, or one that a window
/// brings along. Use one backend per process: two drivers in one process share symbol names.
class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// kAuto takes OSMesa where libOSMesa is installed, else EGL without a surface, in software. Errors (kCannotFinish):
  /// neither library gives a context; the message has the reason of each and the package to install.
  static Result<std::unique_ptr<Context>> open(Backend backend = Backend::kAuto);

  /// A context that somebody else made, a window's, and that is current on this thread now and in every later call.
  /// Errors (kCannotFinish): its driver lacks a function of OpenGL 3.3 core.
  static Result<std::unique_ptr<Context>> current(FindGlFunction find);

  [[nodiscard]] const Gl& gl() const { return gl_; }
  [[nodiscard]] const char* backend_name() const { return backend_name_; }  ///< "OSMesa", "EGL" or "window"
  /// Driver and machine class, for reports: "llvmpipe (LLVM 15.0.6, 256 bits), 3.3 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string driver() const;

 protected:
  explicit Context(const char* backend_name) : backend_name_(backend_name) {}
  Status load(FindGlFunction find);

 private:
  Gl gl_;
  const char* backend_name_;
};

// The two backends; Context::open() chooses.
Result<std::unique_ptr<Context>> open_osmesa();
Result<std::unique_ptr<Context>> open_egl();

}  // namespace tumble::render
