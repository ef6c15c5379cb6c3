// The picture in the making: colour and depth in our own buffers, whatever the window has.
#pragma once

#include "render/gl/functions.h"
#include "render/renderer.h"

namespace tumble {

class Target {
 public:
  // `samples` per pixel, 0 for no smoothing of edges.
  Target(const Gl& gl, int samples) : gl_(gl), samples_(samples) {}
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  // Draws go here from now on; the picture is made anew where its size changes.
  void begin(int width, int height);
  // The finished picture goes to the window.
  void show();
  Picture read();

 private:
  struct Buffers {
    GLuint frame = 0, color = 0, depth = 0;
  };

  Buffers make(int samples, bool with_depth);
  void remove(Buffers& buffers);
  void copy(GLuint from, GLuint to);

  const Gl& gl_;
  int samples_ = 0, width_ = 0, height_ = 0;
  Buffers drawn_, smooth_;  // smooth_ only where there are samples to be averaged
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
