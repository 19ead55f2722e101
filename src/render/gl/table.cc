#include "src/render/gl/table.h"

#include <string>

namespace tumble::render {

// NOLINTNEXTLINE(readability-function-size): two statements for each entry point
Result<Gl> load_gl(const std::function<GlFunction(const char*)>& get_proc) {
  Gl gl;
  std::string missing;
#define TUMBLE_GL_LOAD(type, name)                        \
  gl.name = reinterpret_cast<type>(get_proc("gl" #name)); \
  if (gl.name == nullptr) missing += " gl" #name;
  TUMBLE_GL_FUNCTIONS(TUMBLE_GL_LOAD)
#undef TUMBLE_GL_LOAD
  if (missing.empty()) return gl;
  return cannot_finish("the OpenGL driver lacks" + missing + "; wanted OpenGL 3.3 core, as Mesa's llvmpipe has it");
}

Status check_gl(const Gl& gl, const char* where) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return {};
  while (gl.GetError() != GL_NO_ERROR) {
  }
  if (error == GL_OUT_OF_MEMORY) {
    return cannot_finish(std::string("out of memory in OpenGL (") + where + "); draw a smaller picture");
  }
  return cannot_finish(std::string("OpenGL error ") + std::to_string(error) + " in " + where);
}

}  // namespace tumble::render
