#include "render/null/renderer.h"

namespace tumble {

void NullRenderer::draw(const DrawList& list, int, int) {
  last_ = list;
  ++pictures_;
}

std::unique_ptr<Renderer> make_null_renderer() { return std::make_unique<NullRenderer>(); }

}  // namespace tumble
