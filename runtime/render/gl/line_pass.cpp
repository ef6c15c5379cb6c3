#include "render/gl/line_pass.h"

#include <algorithm>

namespace tumble {

LinePass::LinePass(const Gl& gl)
    : gl_(gl), program_(gl, {"line.vert.glsl"}, {"line.frag.glsl"}), stream_(gl, {3, 3, 4}, 1) {}

void LinePass::draw(const std::vector<DrawLine>& lines, const WideMatrix& matrix, int width, int height) {
  if (lines.empty()) return;
  const double thickness = std::max(1.25, height / 480.0);  // pixels
  program_.use();
  program_.set("matrix", matrix);
  program_.set("half_width", thickness / width, thickness / height);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_DEPTH_TEST);
  draw_some(lines, false);
  gl_.Disable(GL_DEPTH_TEST);
  draw_some(lines, true);
}

void LinePass::draw_some(const std::vector<DrawLine>& lines, bool on_top) {
  floats_.clear();
  GLsizei count = 0;
  for (const DrawLine& line : lines) {
    if (line.on_top != on_top) continue;
    ++count;
    floats_.insert(floats_.end(), line.from.begin(), line.from.end());
    floats_.insert(floats_.end(), line.to.begin(), line.to.end());
    for (const double part : {line.color.r, line.color.g, line.color.b, line.color.a})
      floats_.push_back(static_cast<float>(part));
  }
  if (count == 0) return;
  stream_.use(floats_.data(), floats_.size() * sizeof(float));
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

}  // namespace tumble
