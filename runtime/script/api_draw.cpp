// Drawing helpers in the world and text on the screen.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "render/renderer.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

constexpr double kHeight = 720;  // of the screen, in ui units

void add_line(Script& s, Vec3 from, Vec3 to, const Color& color, bool on_top = false) {
  DrawLine line;
  line.color = color;
  line.on_top = on_top;
  s.drawing().lines.push_back(line);
  s.drawing().ends.emplace_back(from, to);
}

void line(Script& s, Vec3 from, Vec3 to, std::optional<Color> color) { add_line(s, from, to, color.value_or(Color{})); }

void arrow(Script& s, Vec3 from, Vec3 to, std::optional<Color> color) {
  const Color c = color.value_or(Color{});
  add_line(s, from, to, c);
  const Vec3 way = to - from;
  const Vec3 across = normalized(cross(way, std::abs(way.y) < 0.9 * length(way) ? Vec3{0, 1, 0} : Vec3{1, 0, 0})) * (0.08 * length(way));
  add_line(s, to, to - way * 0.2 + across, c);
  add_line(s, to, to - way * 0.2 - across, c);
}

void point(Script& s, Vec3 p, std::optional<double> size, std::optional<Color> color) {
  const double r = size.value_or(0.05);
  for (const Vec3 axis : {Vec3{r, 0, 0}, Vec3{0, r, 0}, Vec3{0, 0, r}}) add_line(s, p - axis, p + axis, color.value_or(Color{}));
}

void path(Script& s, Value points, std::optional<Color> color) {
  std::vector<Vec3> list;
  assign(type_of<std::vector<Vec3>>(), &list, points, "draw.path: points");
  for (std::size_t i = 1; i < list.size(); ++i) add_line(s, list[i - 1], list[i], color.value_or(Color{}));
}

// Text in the world is text on the screen where the place is seen.
void world_text(Script& s, Vec3 position, std::string words, std::optional<Color> color) {
  double x = 0, y = 0;
  if (!to_screen(camera_view(s.live_engine()), position, s.aspect, x, y)) return;
  DrawUi entry;
  entry.is_text = true;
  entry.text = {words, static_cast<float>(x), static_cast<float>(y), 20, color.value_or(Color{}), false};
  s.drawing().ui.push_back(entry);
}

// ---- ui

struct Place { double x = 0, y = 0; };

double number(const Value& options, const char* name, double missing, const char* call) {
  const Value* value = options.find(name);
  if (!value) return missing;
  if (!value->is_number() || !std::isfinite(value->number())) fail(call, ": ", name, ": a finite number expected, got ", tumble::text(*value));
  return value->number();
}

// Where something of that size goes: a named place with a margin, moved by x and y; or at x and y alone.
Place place(const Value& options, double width, double height, double screen_width, const char* call) {
  constexpr double margin = 24;
  const double x = number(options, "x", 0, call), y = number(options, "y", 0, call);
  static const EnumNames names = {"top_left", "top", "top_right", "left", "center", "right", "bottom_left", "bottom", "bottom_right"};
  const Value* at = options.find("at");
  if (!at && (options.find("x") || options.find("y"))) return {x, y};
  const std::string name = at && at->is<std::string>() ? *at->get<std::string>() : "top_left";
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end() || (at && !at->is<std::string>()))
    fail(call, ": at: one of ", join(names), " expected, got ", at ? tumble::text(*at) : "nil", did_you_mean(name, names));
  const auto i = found - names.begin();
  const double xs[] = {margin, (screen_width - width) / 2, screen_width - width - margin};
  const double ys[] = {margin, (kHeight - height) / 2, kHeight - height - margin};
  return {xs[i % 3] + x, ys[i / 3] + y};
}

void check_options(const Value& options, const std::vector<std::string>& known, const std::string& call) {
  if (const Map* map = options.get<Map>())
    for (const auto& [name, value] : *map)
      if (std::find(known.begin(), known.end(), name) == known.end()) fail(call, ": no option '", name, "'; known: ", join(known));
}

Color color_of(const Value& options, const char* name, Color missing, const std::string& call) {
  Color color = missing;
  if (const Value* value = options.find(name)) assign(type_of<Color>(), &color, *value, call + ": " + name);
  return color;
}

void ui_text(Script& s, Anything words, std::optional<Value> given) {
  const Value options = given.value_or(Value{});
  check_options(options, {"at", "x", "y", "size", "color"}, "ui.text");
  const double size = number(options, "size", 28, "ui.text");
  const std::string text = luaL_tolstring(s.stack(), words.index, nullptr);
  lua_pop(s.stack(), 1);
  if (!is_utf8(text)) fail("ui.text: the text is not UTF-8; save the file as UTF-8");
  const TextSize measure = measure_text(text, size);
  const Place at = place(options, measure.width, measure.height, kHeight * s.aspect, "ui.text");
  DrawUi entry;
  entry.is_text = true;
  entry.text = {text, static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(size), color_of(options, "color", {1, 1, 1, 1}, "ui.text"), false};
  s.drawing().ui.push_back(entry);
}

void add_panel(Script& s, double x, double y, double width, double height, Color color) {
  DrawUi entry;
  entry.panel = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(width), static_cast<float>(height), color};
  s.drawing().ui.push_back(entry);
}

void bar(Script& s, double fraction, std::optional<Value> given) {
  const Value options = given.value_or(Value{});
  check_options(options, {"at", "x", "y", "width", "height", "color"}, "ui.bar");
  const double width = number(options, "width", 240, "ui.bar"), height = number(options, "height", 16, "ui.bar");
  const Place at = place(options, width, height, kHeight * s.aspect, "ui.bar");
  add_panel(s, at.x, at.y, width, height, {0, 0, 0, 0.45});
  add_panel(s, at.x, at.y, width * std::clamp(fraction, 0.0, 1.0), height, color_of(options, "color", {1, 1, 1, 1}, "ui.bar"));
}

void box(Script& s, Value options) {
  check_options(options, {"at", "x", "y", "width", "height", "color"}, "ui.box");
  const double width = number(options, "width", 240, "ui.box"), height = number(options, "height", 120, "ui.box");
  const Place at = place(options, width, height, kHeight * s.aspect, "ui.box");
  add_panel(s, at.x, at.y, width, height, color_of(options, "color", {0, 0, 0, 0.55}, "ui.box"));
}

double ui_width(Script& s) { return kHeight * s.aspect; }
double ui_height(Script&) { return kHeight; }

}  // namespace

void Script::note_ray(Vec3 from, Vec3 to) {
  if (live_settings_.debug_view != DebugView::physics || phase_ != Phase::run || tick_drawing_.lines.size() > 10000) return;
  add_line(*this, from, to, {1, 1, 0, 1});
}

void rows_draw(Area& a) {
  a.fn<line>("line", "A line between two points.", "from", "to", "color");
  a.fn<arrow>("arrow", "An arrow from one point to another.", "from", "to", "color");
  a.fn<point>("point", "A small cross.", "position", "size", "color");
  a.fn<path>("path", "Lines through a list of points.", "points", "color").takes(0, "list of vec3");
  a.fn<world_text>("text", "Text at a place in the world.", "position", "text", "color");
}

void rows_ui(Area& a) {
  a.fn<ui_text>("text", "Writes a text. Options: at (\"top_left\" ... \"center\" ... \"bottom_right\"), moved by x and y, or x and y alone; size, color.", "text", "options").takes(1, "table");
  a.fn<bar>("bar", "A bar that is filled to a fraction. Options: at, x, y as for text; width, height, color.", "fraction", "options").takes(1, "table");
  a.fn<box>("box", "A filled rectangle, to stand behind text. Options: at, x, y as for text; width, height, color.", "options").takes(0, "table");
  a.prop<ui_width>("width", "The screen's width in ui units: 1280 at 16:9.");
  a.prop<ui_height>("height", "The screen's height in ui units: always 720.");
}

}  // namespace tumble
