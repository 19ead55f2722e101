#include "src/render/gl/context.h"

#include <utility>

namespace tumble::render {

Result<std::unique_ptr<Context>> Context::open(Backend backend) {
  if (backend == Backend::kOsmesa) return open_osmesa();
  if (backend == Backend::kEgl) return open_egl();
  Result<std::unique_ptr<Context>> osmesa = open_osmesa();
  if (osmesa.ok()) return osmesa;
  Result<std::unique_ptr<Context>> egl = open_egl();
  if (egl.ok()) return egl;
  return cannot_finish("no OpenGL to draw with; " + osmesa.error().message + "; " + egl.error().message +
                       ". Debian has both: install libosmesa6, or libegl1 with libgl1-mesa-dri");
}

namespace {

class WindowContext : public Context {
 public:
  WindowContext() : Context("window") {}
  Status start(FindGlFunction find) { return load(find); }
};

}  // namespace

Result<std::unique_ptr<Context>> Context::current(FindGlFunction find) {
  auto context = std::make_unique<WindowContext>();
  if (const Status started = context->start(find); !started.ok()) return started.error();
  return std::unique_ptr<Context>(std::move(context));
}

Status Context::load(FindGlFunction find) {
  Result<Gl> gl = load_gl(find);
  if (!gl.ok()) return gl.error();
  gl_ = *gl;
  return {};
}

std::string Context::driver() const {
  const auto text = [&](GLenum name) {
    const GLubyte* found = gl_.GetString(name);
    return found == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(found));
  };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

}  // namespace tumble::render
