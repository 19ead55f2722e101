#pragma once

#include <utility>

#include "src/base/result.h"
#include "src/render/gl/table.h"

namespace tumble::render {

/// Owns one GL name. The table that made it must outlive it, and its context be current when it dies.
class GlObject {
 public:
  enum class Kind { kTexture, kFramebuffer, kBuffer, kVertexArray, kShader, kProgram };

  GlObject() = default;
  /// Adopts a name.
  GlObject(const Gl& gl, Kind kind, GLuint id) : gl_(&gl), kind_(kind), id_(id) {}
  /// Makes a new texture, framebuffer, buffer or vertex array.
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

/// What a pass draws into: a colour texture, a depth texture, or both, of one size.
class RenderTarget {
 public:
  /// kBytes: 8 bits a channel as unsigned integers, because conversions to normalised bytes differ between versions
  /// of Mesa. kFloats: 32 bits. kDepthOnly: no colour; its 32-bit depth is filtered and compared when it is looked up.
  enum class Format { kBytes, kBytesWithDepth, kFloats, kDepthOnly };

  RenderTarget() = default;
  /// Errors (kCannotFinish): the driver cannot draw into that size or format.
  static Result<RenderTarget> create(const Gl& gl, int width, int height, Format format);

  /// Makes it what is drawn into, all of it.
  void bind(const Gl& gl) const;
  /// Binds its texture (the depth's for kDepthOnly) to a texture unit, to be read.
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
