#pragma once

#include <string>

#include "src/render/gl/objects.h"
#include "src/render/scene/view.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// A linked vertex and fragment shader. Call use() before set(), which sets a uniform by name.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// Compiles both texts behind "#version 330 core". Errors (kCannotFinish): the compiler of the driver refuses a text;
  /// the message has `name` and the words of the compiler.
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

/// The vertex shader of passes over the whole image: one triangle that covers the image, without a buffer.
extern const char* const kFullScreenVertices;

/// Draws that triangle into the bound target. `empty` is a vertex array without attributes.
void draw_full_screen(const Gl& gl, const GlObject& empty);

}  // namespace tumble::render
