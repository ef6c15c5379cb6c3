// The renderer of headless runs: draws nothing, but keeps what it was to draw.
#pragma once

#include "render/renderer.h"

namespace tumble {

class NullRenderer final : public Renderer {
 public:
  void draw(const DrawList& list, int width, int height) override;
  Picture picture() override { return {}; }
  bool is_null() const override { return true; }

  const DrawList& last() const { return last_; }
  int pictures() const { return pictures_; }

 private:
  DrawList last_;
  int pictures_ = 0;
};

}  // namespace tumble
