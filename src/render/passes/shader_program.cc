#include "src/render/passes/shader_program.h"

#include <algorithm>
#include <vector>

namespace tumble::render {
namespace {

const char* const kVersion = "#version 330 core\n";

Error refused(const char* name, const char* what, std::string words) {
  while (!words.empty() && (words.back() == '\0' || words.back() == '\n')) words.pop_back();
  return cannot_finish(std::string("the OpenGL driver refuses the ") + what + " of " + name + ": " + words);
}

Result<GlObject> compile(const Gl& gl, const char* name, GLenum kind, const std::string& body) {
  GlObject shader(gl, GlObject::Kind::kShader, gl.CreateShader(kind));
  const std::string text = kVersion + body;
  const char* source = text.c_str();
  gl.ShaderSource(shader.id(), 1, &source, nullptr);
  gl.CompileShader(shader.id());
  GLint compiled = GL_FALSE, length = 0;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  gl.GetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
  std::string words(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.GetShaderInfoLog(shader.id(), length, nullptr, words.data());
  return refused(name, kind == GL_VERTEX_SHADER ? "vertex shader" : "fragment shader", words);
}

}  // namespace

const char* const kFullScreenVertices = R"(
void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";

void draw_full_screen(const Gl& gl, const GlObject& empty) {
  gl.BindVertexArray(empty.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

Result<ShaderProgram> ShaderProgram::create(const Gl& gl, const char* name, const std::string& vertex,
                                            const std::string& fragment) {
  const Result<GlObject> vertices = compile(gl, name, GL_VERTEX_SHADER, vertex);
  if (!vertices.ok()) return vertices.error();
  const Result<GlObject> fragments = compile(gl, name, GL_FRAGMENT_SHADER, fragment);
  if (!fragments.ok()) return fragments.error();
  ShaderProgram made;
  made.program_ = GlObject(gl, GlObject::Kind::kProgram, gl.CreateProgram());
  const GLuint id = made.program_.id();
  gl.AttachShader(id, vertices->id());
  gl.AttachShader(id, fragments->id());
  gl.LinkProgram(id);
  GLint linked = GL_FALSE, length = 0;
  gl.GetProgramiv(id, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return made;
  gl.GetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string words(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.GetProgramInfoLog(id, length, nullptr, words.data());
  return refused(name, "linked program", words);
}

GLint ShaderProgram::place(const Gl& gl, const char* uniform) const {
  return gl.GetUniformLocation(program_.id(), uniform);
}

void ShaderProgram::set(const Gl& gl, const char* uniform, int value) const { gl.Uniform1i(place(gl, uniform), value); }
void ShaderProgram::set(const Gl& gl, const char* uniform, int x, int y) const {
  gl.Uniform2i(place(gl, uniform), x, y);
}
void ShaderProgram::set(const Gl& gl, const char* uniform, float value) const {
  gl.Uniform1f(place(gl, uniform), value);
}
void ShaderProgram::set(const Gl& gl, const char* uniform, float x, float y) const {
  gl.Uniform2f(place(gl, uniform), x, y);
}
void ShaderProgram::set(const Gl& gl, const char* uniform, const sim::Vec3& value) const {
  gl.Uniform3f(place(gl, uniform), static_cast<float>(value.x()), static_cast<float>(value.y()),
               static_cast<float>(value.z()));
}
void ShaderProgram::set(const Gl& gl, const char* uniform, const Matrix& value) const {
  gl.UniformMatrix4fv(place(gl, uniform), 1, GL_FALSE, to_floats(value).data());
}

}  // namespace tumble::render
