// Draws lists. The GL renderer makes pictures; the null renderer counts and keeps, for headless runs and tests.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/draw_list.h"

namespace tumble {

class Window;

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // RGB, rows from the top
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual void draw(const DrawList& list, int width, int height) = 0;
  // Returns when the picture drawn last is finished.
  virtual void finish() {}
  // The picture drawn last; empty for a renderer that makes none.
  virtual Picture picture() = 0;
  virtual bool is_null() const { return false; }
};

// What is done for a picture: what suits the driver, or all that a graphics card does, or what a processor does.
enum class DrawQuality { by_driver, full, software };
// `window` outlives the renderer. Throws Error where a shader does not compile, with the driver's words.
std::unique_ptr<Renderer> make_gl_renderer(Window& window, DrawQuality quality = DrawQuality::by_driver);
std::unique_ptr<Renderer> make_null_renderer();

// How wide and high a text is in ui units, without a renderer: the same in headless runs.
struct TextSize { double width = 0, height = 0; };
TextSize measure_text(const std::string& text, double size, bool mono = false);

// Throws Error where the file cannot be written.
void write_png(const Picture& picture, const std::string& file);

}  // namespace tumble
