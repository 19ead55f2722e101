#include "src/render/gl/objects.h"

#include <string>

namespace tumble::render {
namespace {

struct TexelFormat {
  GLint stored;
  GLenum format;
  GLenum type;
};

constexpr TexelFormat kByteTexels = {GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE};
constexpr TexelFormat kFloatTexels = {GL_RGBA32F, GL_RGBA, GL_FLOAT};
constexpr TexelFormat kDepthTexels = {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};

GlObject make_texture(const Gl& gl, int width, int height, const TexelFormat& texels, GLint filter) {
  GlObject texture = GlObject::make(gl, GlObject::Kind::kTexture);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, texels.stored, width, height, 0, texels.format, texels.type, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

}  // namespace

GlObject GlObject::make(const Gl& gl, Kind kind) {
  GLuint id = 0;
  if (kind == Kind::kTexture) gl.GenTextures(1, &id);
  if (kind == Kind::kFramebuffer) gl.GenFramebuffers(1, &id);
  if (kind == Kind::kBuffer) gl.GenBuffers(1, &id);
  if (kind == Kind::kVertexArray) gl.GenVertexArrays(1, &id);
  return {gl, kind, id};
}

void GlObject::reset() {
  if (id_ == 0) return;
  if (kind_ == Kind::kTexture) gl_->DeleteTextures(1, &id_);
  if (kind_ == Kind::kFramebuffer) gl_->DeleteFramebuffers(1, &id_);
  if (kind_ == Kind::kBuffer) gl_->DeleteBuffers(1, &id_);
  if (kind_ == Kind::kVertexArray) gl_->DeleteVertexArrays(1, &id_);
  if (kind_ == Kind::kShader) gl_->DeleteShader(id_);
  if (kind_ == Kind::kProgram) gl_->DeleteProgram(id_);
  id_ = 0;
}

Result<RenderTarget> RenderTarget::create(const Gl& gl, int width, int height, Format format) {
  RenderTarget target;
  target.width_ = width;
  target.height_ = height;
  target.format_ = format;
  target.framebuffer_ = GlObject::make(gl, GlObject::Kind::kFramebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer_.id());
  const bool is_depth_only = format == Format::kDepthOnly;
  if (!is_depth_only) {
    const bool is_float = format == Format::kFloats;
    target.colour_ =
        make_texture(gl, width, height, is_float ? kFloatTexels : kByteTexels, is_float ? GL_LINEAR : GL_NEAREST);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour_.id(), 0);
  }
  if (is_depth_only || format == Format::kBytesWithDepth) {
    target.depth_ = make_texture(gl, width, height, kDepthTexels, is_depth_only ? GL_LINEAR : GL_NEAREST);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth_.id(), 0);
  }
  if (is_depth_only) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
  }
  const Status made = check_gl(gl, "making a target to draw into");
  if (!made.ok()) return made.error();
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return cannot_finish("the OpenGL driver cannot draw into " + std::to_string(width) + " x " +
                         std::to_string(height) + " pixels of the wanted format");
  }
  return target;
}

void RenderTarget::bind(const Gl& gl) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.Viewport(0, 0, width_, height_);
}

void RenderTarget::bind_texture(const Gl& gl, int unit) const {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, format_ == Format::kDepthOnly ? depth_.id() : colour_.id());
}

}  // namespace tumble::render
