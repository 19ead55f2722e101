#pragma once

#include <utility>

#include "src/render/gl/table.h"
#include "tumble/sim/result.h"

namespace tumble::render {

/// Owns one GL name. `gl` must outlive the object, and the context must be current when the object is destroyed.
class GlObject {
 public:
  enum class Kind { kTexture, kFramebuffer, kBuffer, kVertexArray, kShader, kProgram };

  GlObject() = default;
  /// Takes over a name.
  GlObject(const Gl& gl, Kind kind, GLuint id) : gl_(&gl), kind_(kind), id_(id) {}
  /// Creates a texture, framebuffer, buffer or vertex array.
  static GlObject make(const Gl& gl, Kind kind);
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept { *this = std::move(other); }
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(kind_, other.kind_);
    std::swap(id_, other.id_);
    return *this;
  }

  [[nodiscard]] GLuint id() const { return id_; }

 private:
  void reset();

  const Gl* gl_ = nullptr;
  Kind kind_ = Kind::kTexture;
  GLuint id_ = 0;
};

/// The textures that a pass draws into: colour, depth, or both, of one size.
class RenderTarget {
 public:
  /// kBytes: 8 bits per channel as unsigned integers, because conversions to normalised bytes differ between versions
  /// of Mesa. kFloats: 32 bits. kDepthOnly: no colour; look-ups filter and compare the 32-bit depth.
  enum class Format { kBytes, kBytesWithDepth, kFloats, kDepthOnly };

  RenderTarget() = default;
  /// Errors (kCannotFinish): the driver does not support the size or the format.
  static Result<RenderTarget> create(const Gl& gl, int width, int height, Format format);

  /// Directs drawing to the whole target.
  void bind(const Gl& gl) const;
  /// Binds the texture (for kDepthOnly: of depth) to a texture unit for reading.
  void bind_texture(const Gl& gl, int unit) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  int width_ = 0;
  int height_ = 0;
  Format format_ = Format::kBytes;
  GlObject colour_;
  GlObject depth_;
  GlObject framebuffer_;
};

}  // namespace tumble::render
