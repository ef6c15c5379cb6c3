// The picture in the making: colour and depth in our own buffers, whatever the window has.
#pragma once

#include "render/gl/functions.h"
#include "render/gl/program.h"
#include "render/renderer.h"

namespace tumble {

class Target {
 public:
  // `samples` per pixel, 0 for no smoothing of edges.
  Target(const Gl& gl, int samples);
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  // Draws go here from now on; the picture is made anew where its size changes.
  void begin(int width, int height);
  // The finished picture goes to the window.
  void show();
  Picture read();

 private:
  void make();
  void remove();
  // Of the framebuffer at hand.
  void attach_buffer(GLuint& buffer, GLenum format, GLenum place);
  void attach_picture();

  const Gl& gl_;
  int samples_ = 0, width_ = 0, height_ = 0;
  GLuint frame_ = 0, picture_ = 0;              // the finished picture, a texture
  GLuint drawn_ = 0, color_ = 0, depth_ = 0;    // what is drawn into: frame_, unless there are samples to be averaged
  GLuint no_array_ = 0;
  Program show_program_;
};

// A texture of depths seen from the sun: square maps side by side.
class ShadowMap {
 public:
  ShadowMap(const Gl& gl, int size, int maps);
  ~ShadowMap();
  ShadowMap(const ShadowMap&) = delete;
  ShadowMap& operator=(const ShadowMap&) = delete;

  int size() const { return size_; }
  int maps() const { return maps_; }
  // Clears all; draws go into the first one then.
  void begin();
  void use_map(int map);
  // For a sampler2DShadow, on the given texture unit.
  void bind(int unit);

 private:
  const Gl& gl_;
  int size_ = 0, maps_ = 0;
  GLuint frame_ = 0, depth_ = 0;
};

}  // namespace tumble
