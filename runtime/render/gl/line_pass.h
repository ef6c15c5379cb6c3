// Debug lines: those in the world first, then those seen through everything.
#pragma once

#include <vector>

#include "render/draw_list.h"
#include "render/gl/program.h"
#include "render/gl/stream.h"

namespace tumble {

class LinePass {
 public:
  explicit LinePass(const Gl& gl);
  void draw(const std::vector<DrawLine>& lines, const WideMatrix& matrix, int width, int height);

 private:
  void draw_some(const std::vector<DrawLine>& lines, bool on_top);

  const Gl& gl_;
  Program program_;
  Stream stream_;
  std::vector<float> floats_;
};

}  // namespace tumble
