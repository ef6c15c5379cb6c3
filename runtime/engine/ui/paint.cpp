// How widgets look: from placed elements to panels and letters.
#include <algorithm>

#include "engine/ui/layout.h"
#include "engine/ui/ui.h"
#include "render/renderer.h"

namespace tumble {

namespace {

constexpr double kRadius = 10;         // of widgets
constexpr double kPale = 0.4;          // of what cannot be used

float f(double value) { return static_cast<float>(value); }

Color faded(Color color, double factor) {
  color.a *= factor;
  return color;
}

// Dark on bright colours and bright on dark ones, by how bright they look.
Color ink_on(const Color& color) {
  const double brightness = 0.299 * color.r + 0.587 * color.g + 0.114 * color.b;
  return brightness > 0.5 ? Color{0.08, 0.09, 0.12, 1} : Color{1, 1, 1, 1};
}

void add_panel(std::vector<DrawUi>& out, const UiRect& rect, const Color& color, double radius) {
  if (color.a <= 0 || rect.width <= 0 || rect.height <= 0) return;
  DrawUi entry;
  entry.panel.x = f(rect.x);
  entry.panel.y = f(rect.y);
  entry.panel.width = f(rect.width);
  entry.panel.height = f(rect.height);
  entry.panel.color = color;
  entry.panel.radius = f(std::min(radius, std::min(rect.width, rect.height) / 2));
  out.push_back(entry);
}

void add_text(std::vector<DrawUi>& out, const std::string& text, double x, double y, double size, const Color& color) {
  if (text.empty()) return;
  DrawUi entry;
  entry.is_text = true;
  entry.text.text = text;
  entry.text.x = f(x);
  entry.text.y = f(y);
  entry.text.size = f(size);
  entry.text.color = color;
  out.push_back(std::move(entry));
}

double middle(const UiRect& rect, double size) { return rect.y + (rect.height - size) / 2; }

// Each line by itself, since each stands elsewhere. What has no panel behind it gets a shadow, to be read over the sky.
void paint_text(const UiElement& e, bool shadow, std::vector<DrawUi>& out) {
  const std::string lines = wrap_text(e.text, e.size, e.rect.width);
  const UiAlign align = e.align.value_or(UiAlign::left);
  double y = e.rect.y;
  for (std::size_t begin = 0; begin <= lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    const std::string line = lines.substr(begin, end - begin);
    const double free = align == UiAlign::left ? 0 : e.rect.width - measure_text(line, e.size).width;
    const double x = e.rect.x + (align == UiAlign::center ? free / 2 : free), drop = std::max(1.0, e.size / 18);
    if (shadow) add_text(out, line, x + drop, y + drop, e.size, {0, 0, 0, 0.45 * e.color.a});
    add_text(out, line, x, y, e.size, e.color);
    y += e.size;
    begin = end + 1;
  }
}

void paint_image(const UiElement& e, std::vector<DrawUi>& out) {
  const std::size_t before = out.size();
  add_panel(out, e.rect, e.color, 0);
  if (out.size() > before) out.back().panel.image = e.text;
}

void paint_bar(const UiElement& e, std::vector<DrawUi>& out) {
  add_panel(out, e.rect, {0, 0, 0, 0.45}, e.rect.height / 2);
  UiRect filled = e.rect;
  filled.width *= e.fraction;
  add_panel(out, filled, e.color, e.rect.height / 2);
}

}  // namespace

// Is there a panel behind it?
bool Ui::has_ground(const UiElement& e) const {
  for (int c = e.parent; c > 0; c = elements_[static_cast<std::size_t>(c)].parent) {
    const UiElement& column = elements_[static_cast<std::size_t>(c)];
    if (column.visible && column.color.a > 0.3) return true;
  }
  return false;
}

void Ui::paint(std::vector<DrawUi>& out) const {
  for (const UiElement& e : elements_) paint_element(e, out);
}

void Ui::paint_element(const UiElement& e, std::vector<DrawUi>& out) const {
  switch (e.kind) {
    case UiKind::column:
      if (e.visible) add_panel(out, e.rect, e.color, e.radius);
      break;
    case UiKind::row:
    case UiKind::space: break;
    case UiKind::box: add_panel(out, e.rect, e.color, e.radius); break;
    case UiKind::bar: paint_bar(e, out); break;
    case UiKind::image: paint_image(e, out); break;
    case UiKind::text: paint_text(e, !has_ground(e), out); break;
    default: paint_widget(e, out);
  }
}

// A widget in focus is filled with the accent if it only has a label; others keep a dark ground, on which their accent
// shows, and take a bright edge.
void Ui::paint_widget(const UiElement& e, std::vector<DrawUi>& out) const {
  const bool bright = e.enabled && (e.key == focus_ || (pointer_used_ && e.key == hover_));
  const bool down = e.enabled && e.key == held_ && e.key == hover_;
  const double inset = ui_inset(e.size), y = middle(e.rect, e.size), pale = e.enabled ? 1 : kPale;
  Color ground = e.color, label = faded(e.text_color, pale);
  if (e.kind == UiKind::button && bright) {
    ground = down ? faded(style_.accent, 0.75) : style_.accent;
    label = ink_on(style_.accent);
  } else if (bright) {
    ground.a = std::min(1.0, ground.a + (down ? 0.14 : 0.08));
  }
  if (!has_ground(e)) add_panel(out, e.rect, style_.panel, kRadius);
  add_panel(out, e.rect, faded(ground, e.enabled ? 1 : 0.6), kRadius);
  if (e.kind == UiKind::button) return add_text(out, e.text, e.rect.x + (e.rect.width - e.label_width) / 2, y, e.size, label);
  if (e.kind == UiKind::list) return paint_list(e, bright, out);
  if (bright) add_panel(out, {e.rect.x, e.rect.y + 8, 5, e.rect.height - 16}, style_.accent, 2.5);

  add_text(out, e.text, e.rect.x + inset, y, e.size, label);
  const double right = e.rect.right() - inset;
  const Color accent = faded(style_.accent, pale), dim{0, 0, 0, 0.4};
  if (e.kind == UiKind::toggle) {
    const double high = 0.8 * e.size, wide = 1.4 * e.size, knob = high - 6;
    const UiRect pill{right - wide, middle(e.rect, high), wide, high};
    add_panel(out, pill, e.on ? accent : dim, high / 2);
    add_panel(out, {e.on ? pill.right() - 3 - knob : pill.x + 3, pill.y + 3, knob, knob}, faded({1, 1, 1, 1}, pale), knob / 2);
  } else if (e.kind == UiKind::slider) {
    const UiRect track = ui_slider_track(e);
    const double at = track.x + track.width * e.fraction, knob = 0.75 * e.size;
    add_panel(out, {track.x, middle(e.rect, 8), track.width, 8}, dim, 4);
    add_panel(out, {track.x, middle(e.rect, 8), at - track.x, 8}, accent, 4);
    add_panel(out, {at - knob / 2, middle(e.rect, knob), knob, knob}, faded({1, 1, 1, 1}, pale), knob / 2);
    add_text(out, e.value, right - e.value_width, y, e.size, label);
  } else if (e.kind == UiKind::field) {
    const double left = e.rect.x + (e.text.empty() ? inset / 2 : e.label_width + 2 * inset);
    add_panel(out, {left, e.rect.y + 5, e.rect.right() - 5 - left, e.rect.height - 10}, dim, kRadius - 4);
    const bool caret = e.key == focus_ && e.enabled && ticks_ / 30 % 2 == 0;
    add_text(out, e.value, left + inset / 2, y, e.size, label);
    if (caret) add_panel(out, {left + inset / 2 + e.value_width + 2, y + 2, 2.5, e.size - 4}, style_.accent, 1);
  } else if (e.kind == UiKind::key) {
    const double wide = e.value_width + 1.2 * inset;
    add_panel(out, {right - wide, e.rect.y + 6, wide, e.rect.height - 12}, dim, kRadius - 4);
    add_text(out, e.value, right - wide / 2 - e.value_width / 2, y, e.size, e.key == waiting_ ? accent : label);
  }
}

void Ui::paint_list(const UiElement& e, bool bright, std::vector<DrawUi>& out) const {
  const double high = ui_item_height(e), inset = ui_inset(e.size);
  const int count = static_cast<int>(e.items.size()), shown = ui_shown_items(e);
  const double bar = count > shown ? 14 : 0;
  for (int i = e.first; i < std::min(count, e.first + shown); ++i) {
    const UiRect row{e.rect.x + ui_list_padding, e.rect.y + ui_list_padding + (i - e.first) * high, e.rect.width - 2 * ui_list_padding - bar, high};
    const bool selected = i + 1 == e.selected;
    if (selected) add_panel(out, row, bright ? style_.accent : faded(style_.accent, 0.3), kRadius - 4);
    const Color color = selected && bright ? ink_on(style_.accent) : faded(e.text_color, e.enabled ? 1 : kPale);
    const std::string& item = e.items[static_cast<std::size_t>(i)];
    if (item.empty()) continue;
    add_text(out, item, row.x + inset, middle(row, e.size), e.size, color);
    out.back().clip = {f(row.x), f(row.y), f(row.width), f(row.height)};
  }
  if (bar == 0) return;
  const double room = e.rect.height - 2 * ui_list_padding, length = std::max(24.0, room * shown / count);
  const double at = (room - length) * e.first / (count - shown);
  add_panel(out, {e.rect.right() - ui_list_padding - 6, e.rect.y + ui_list_padding, 6, room}, {0, 0, 0, 0.35}, 3);
  add_panel(out, {e.rect.right() - ui_list_padding - 6, e.rect.y + ui_list_padding + at, 6, length}, bright ? style_.accent : Color{1, 1, 1, 0.4}, 3);
}

}  // namespace tumble
