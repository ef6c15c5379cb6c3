#include "render/gl/target.h"

#include <algorithm>

#include "base/error.h"

namespace tumble {
namespace {

void check_complete(const Gl& gl, const char* what, int width, int height) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    fail("renderer: the graphics driver cannot draw into ", what, " of ", width, " x ", height, " pixels (status ",
         status, "); make the window smaller or update the driver");
}

}  // namespace

Target::Target(const Gl& gl, int samples) : gl_(gl), samples_(samples), show_program_(gl, {"show.vert.glsl"}, {"show.frag.glsl"}) {
  gl_.GenVertexArrays(1, &no_array_);
}

Target::~Target() {
  remove();
  gl_.DeleteVertexArrays(1, &no_array_);
}

void Target::attach_buffer(GLuint& buffer, GLenum format, GLenum place) {
  gl_.GenRenderbuffers(1, &buffer);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, format, width_, height_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
}

void Target::attach_picture() {
  gl_.GenTextures(1, &picture_);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, picture_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (const GLenum way : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) gl_.TexParameteri(GL_TEXTURE_2D, way, GL_NEAREST);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_, 0);
}

void Target::make() {
  gl_.GenFramebuffers(1, &frame_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  attach_picture();
  drawn_ = frame_;
  if (samples_ > 0) {
    check_complete(gl_, "a picture", width_, height_);
    gl_.GenFramebuffers(1, &drawn_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_);
    attach_buffer(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  }
  attach_buffer(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  check_complete(gl_, "a picture", width_, height_);
}

void Target::remove() {
  const GLuint frames[] = {frame_, drawn_ == frame_ ? 0 : drawn_}, buffers[] = {color_, depth_};
  gl_.DeleteFramebuffers(2, frames);
  gl_.DeleteRenderbuffers(2, buffers);
  gl_.DeleteTextures(1, &picture_);
  frame_ = picture_ = drawn_ = color_ = depth_ = 0;
}

void Target::begin(int width, int height) {
  if (width != width_ || height != height_) {
    remove();
    width_ = width;
    height_ = height;
    make();
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_);
  gl_.Viewport(0, 0, width_, height_);
}

// Drawn rather than copied: Mesa's way of copying into a window compiles a shader of its own, in every run.
void Target::show() {
  if (samples_ > 0) {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, picture_);
  show_program_.use();
  show_program_.set("picture", 0);
  gl_.BindVertexArray(no_array_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.BindVertexArray(0);
}

Picture Target::read() {
  Picture picture;
  if (width_ == 0) return picture;
  const std::size_t pixels = static_cast<std::size_t>(width_) * height_;
  std::vector<std::uint8_t> rgba(pixels * 4);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);

  picture = {width_, height_, std::vector<std::uint8_t>(pixels * 3)};
  for (int y = 0; y < height_; ++y)  // GL's rows run upwards
    for (int x = 0; x < width_; ++x) {
      const std::uint8_t* from = &rgba[4 * (static_cast<std::size_t>(height_ - 1 - y) * width_ + x)];
      std::copy(from, from + 3, &picture.pixels[3 * (static_cast<std::size_t>(y) * width_ + x)]);
    }
  return picture;
}

ShadowMap::ShadowMap(const Gl& gl, int size, int maps) : gl_(gl), size_(size), maps_(maps) {
  gl_.GenTextures(1, &depth_);
  gl_.BindTexture(GL_TEXTURE_2D, depth_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size * maps, size, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  for (const GLenum way : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, way, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);

  const GLenum none = GL_NONE;
  gl_.GenFramebuffers(1, &frame_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  gl_.DrawBuffers(1, &none);
  gl_.ReadBuffer(GL_NONE);
  check_complete(gl_, "a shadow map", size, size);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

ShadowMap::~ShadowMap() {
  gl_.DeleteFramebuffers(1, &frame_);
  gl_.DeleteTextures(1, &depth_);
}

void ShadowMap::begin() {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  use_map(0);
}

void ShadowMap::use_map(int map) { gl_.Viewport(map * size_, 0, size_, size_); }

void ShadowMap::bind(int unit) {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, depth_);
}

}  // namespace tumble
