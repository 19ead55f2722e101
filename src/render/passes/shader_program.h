#pragma once

#include <string>

#include "src/base/result.h"
#include "src/render/gl/objects.h"
#include "src/render/scene/view.h"

namespace tumble::render {

/// A vertex and a fragment shader, linked. Uniforms are set by name while it is in use.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// The texts go behind "#version 330 core". Errors (kCannotFinish): the driver's compiler refuses one; `name` and its
  /// words are in the message.
  static Result<ShaderProgram> create(const Gl& gl, const char* name, const std::string& vertex,
                                      const std::string& fragment);

  void use(const Gl& gl) const { gl.UseProgram(program_.id()); }
  void set(const Gl& gl, const char* uniform, int value) const;
  void set(const Gl& gl, const char* uniform, int x, int y) const;
  void set(const Gl& gl, const char* uniform, float value) const;
  void set(const Gl& gl, const char* uniform, float x, float y) const;
  void set(const Gl& gl, const char* uniform, const sim::Vec3& value) const;
  void set(const Gl& gl, const char* uniform, const Matrix& value) const;

 private:
  [[nodiscard]] GLint place(const Gl& gl, const char* uniform) const;
  GlObject program_;
};

/// The vertex shader of passes over the whole image: one triangle that covers it, without any buffer.
extern const char* const kFullScreenVertices;

/// Draws that triangle into the bound target. `empty` is a vertex array without attributes.
void draw_full_screen(const Gl& gl, const GlObject& empty);

}  // namespace tumble::render
