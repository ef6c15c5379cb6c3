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
constexpr double kEverywhere = 1e9;    // pixels

// Half pixels, so that a text that grows slowly does not need a new set of letters in every picture.
double stepped(double size) { return std::max(1.0, std::round(size * 2) / 2); }

}  // namespace

UiPass::UiPass(const Gl& gl)
    : gl_(gl), program_(gl, {"ui.vert.glsl"}, {"srgb.glsl", "ui.frag.glsl"}), stream_(gl, {2, 2, 4, 4, 1}, 0),
      atlas_(gl) {}

void UiPass::draw(const std::vector<DrawUi>& ui, Textures& textures, int width, int height) {
  if (ui.empty() || height <= 0) return;
  const double scale = height / kUiHeight;
  if (!build(ui, textures, scale)) {
    atlas_.clear();
    build(ui, textures, scale);
  }
  program_.use();
  program_.set("picture_size", width, height);
  program_.set("picture", 0);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  stream_.use(corners_.data(), corners_.size() * sizeof(Corner));
  for (const Run& run : runs_) {
    program_.set("is_image", run.image != 0);
    if (run.image != 0) textures.bind(run.image, 0, false);
    else atlas_.bind(0);
    gl_.DrawArrays(GL_TRIANGLES, static_cast<GLint>(run.first), static_cast<GLsizei>(run.count));
  }
}

bool UiPass::build(const std::vector<DrawUi>& ui, Textures& textures, double scale) {
  corners_.clear();
  runs_.clear();
  bool complete = true;
  for (const DrawUi& item : ui) {
    const auto& [left, top, width, height] = item.clip;
    clip_ = {-kEverywhere, -kEverywhere, kEverywhere, kEverywhere};
    if (width > 0)
      clip_ = {std::round(left * scale), std::round(top * scale), std::round((left + width) * scale),
               std::round((top + std::max(height, 0.0f)) * scale)};
    if (item.is_text) complete = add_text(item.text, scale) && complete;
    else add_panel(item.panel, textures, scale);
  }
  return complete;
}

void UiPass::use_image(GLuint image) {
  if (runs_.empty() || runs_.back().image != image) runs_.push_back({image, corners_.size(), 0});
}

void UiPass::add_panel(const DrawPanel& p, Textures& textures, double scale) {
  // Whole pixels: neighbouring panels then meet without a seam.
  const Rectangle place{std::round(p.x * scale), std::round(p.y * scale), std::round((p.x + p.width) * scale),
                        std::round((p.y + p.height) * scale)};
  const double most = std::min(place.right - place.left, place.bottom - place.top) / 2;
  const double radius = std::clamp(p.radius * scale, 0.0, std::max(most, 0.0));
  if (p.image.empty()) {
    use_image(0);
    add(place, atlas_.filled(), p.color, radius);
  } else {
    use_image(textures.find({p.image, -1}).texture);
    add(place, {0, 0, 1, 1, 0, 0, 0, 0}, p.color, radius);
  }
}

bool UiPass::add_text(const DrawText& text, double scale) {
  if (!(text.size > 0)) return true;
  use_image(0);
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

void UiPass::add(Rectangle place, const GlyphAtlas::Entry& entry, const Color& color, double radius) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const Rectangle whole = place;
  place = {std::max(place.left, clip_.left), std::max(place.top, clip_.top), std::min(place.right, clip_.right),
           std::min(place.bottom, clip_.bottom)};
  if (place.left >= place.right || place.top >= place.bottom) return;
  const auto corner = [&](bool right, bool bottom) {
    const double x = right ? place.right : place.left, y = bottom ? place.bottom : place.top;
    const double across = (x - whole.left) / (whole.right - whole.left);
    const double down = (y - whole.top) / (whole.bottom - whole.top);
    const double u = entry.u0 + (entry.u1 - entry.u0) * across, v = entry.v0 + (entry.v1 - entry.v0) * down;
    return Corner{f(x),       f(y),       f(u),       f(v),
                  f(color.r), f(color.g), f(color.b), f(color.a),
                  f((whole.left + whole.right) / 2), f((whole.top + whole.bottom) / 2),
                  f((whole.right - whole.left) / 2), f((whole.bottom - whole.top) / 2), f(radius)};
  };
  const Corner a = corner(false, false), b = corner(true, false), c = corner(true, true), d = corner(false, true);
  corners_.insert(corners_.end(), {a, d, c, a, c, b});
  runs_.back().count += 6;
}

}  // namespace tumble
