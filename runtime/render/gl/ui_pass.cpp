#include "render/gl/ui_pass.h"

#include <algorithm>
#include <cmath>

#include "assets/font.h"
#include "render/text.h"

namespace tumble {
namespace {

constexpr double kUiHeight = 720;
// Larger letters are drawn at this size and stretched: they are soft, but do not fill the atlas.
constexpr double kLargestDrawn = 192;  // pixels

// Half pixels, so that a text that grows slowly does not need a new set of letters in every picture.
double stepped(double size) { return std::max(1.0, std::round(size * 2) / 2); }

}  // namespace

UiPass::UiPass(const Gl& gl)
    : gl_(gl), program_(gl, {"ui.vert.glsl"}, {"ui.frag.glsl"}), stream_(gl, {2, 2, 4}, 0), atlas_(gl) {}

void UiPass::draw(const std::vector<DrawUi>& ui, int width, int height) {
  if (ui.empty() || height <= 0) return;
  const double scale = height / kUiHeight;
  if (!build(ui, scale)) {
    atlas_.clear();
    build(ui, scale);
  }
  program_.use();
  program_.set("picture_size", width, height);
  program_.set("atlas", 0);
  atlas_.bind(0);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  stream_.use(corners_.data(), corners_.size() * sizeof(Corner));
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
}

bool UiPass::build(const std::vector<DrawUi>& ui, double scale) {
  corners_.clear();
  bool complete = true;
  for (const DrawUi& item : ui) {
    if (item.is_text) {
      complete = add_text(item.text, scale) && complete;
      continue;
    }
    const DrawPanel& p = item.panel;
    // Whole pixels: neighbouring panels then meet without a seam.
    add({std::round(p.x * scale), std::round(p.y * scale), std::round((p.x + p.width) * scale),
         std::round((p.y + p.height) * scale)},
        atlas_.filled(), p.color);
  }
  return complete;
}

bool UiPass::add_text(const DrawText& text, double scale) {
  if (!(text.size > 0)) return true;
  const double size = text.size * scale;
  const double drawn = std::min(stepped(size), kLargestDrawn), stretch = size > kLargestDrawn ? size / drawn : 1;
  const double ascent = built_in_font(text.mono).ascent() * size;
  bool complete = true;
  lay_out(text.text, size, text.mono, [&](const PlacedLetter& letter) {
    if (letter.letter == U' ' || letter.letter == U'\t') return;
    const double pen = std::floor((text.x * scale + letter.x) * 4 + 0.5) / 4;
    const double left = std::floor(pen), baseline = std::round(text.y * scale + letter.line * size + ascent);
    const GlyphAtlas::Entry* entry = atlas_.find(letter.letter, text.mono, drawn, static_cast<int>((pen - left) * 4));
    if (!entry) {
      complete = false;
      return;
    }
    const double x = left + entry->left * stretch, y = baseline + entry->top * stretch;
    add({x, y, x + entry->width * stretch, y + entry->height * stretch}, *entry, text.color);
  });
  return complete;
}

void UiPass::add(const Rectangle& place, const GlyphAtlas::Entry& entry, const Color& color) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const auto corner = [&](bool right, bool bottom) {
    const float x = f(right ? place.right : place.left), y = f(bottom ? place.bottom : place.top);
    const float u = right ? entry.u1 : entry.u0, v = bottom ? entry.v1 : entry.v0;
    return Corner{x, y, u, v, f(color.r), f(color.g), f(color.b), f(color.a)};
  };
  const Corner a = corner(false, false), b = corner(true, false), c = corner(true, true), d = corner(false, true);
  corners_.insert(corners_.end(), {a, d, c, a, c, b});
}

}  // namespace tumble
