// Drawing helpers in the world.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "engine/ui/options.h"
#include "physics/wire.h"
#include "render/renderer.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

void add_line(Script& s, Vec3 from, Vec3 to, const Color& color) {
  DrawLine line;
  line.color = color;
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

void shape(Script& s, Shape shape, Vec3 position, std::optional<Quat> rotation, std::optional<Color> color) {
  if (!shape.file.empty()) {   // the edges of a whole model hide it; its hull shows where it is
    if (shape.shape != ShapeKind::height_field) shape.shape = ShapeKind::hull;
    shape = s.engine().with_points(shape);
  }
  const Pose place{position, rotation.value_or(Quat{})};
  for (const WireLine& line : wire_of(shape)) add_line(s, place * line.from, place * line.to, color.value_or(Color{}));
}

// Text in the world is text on the screen where the place is seen.
void world_text(Script& s, Vec3 position, std::string words, std::optional<Color> color, std::optional<double> size) {
  if (size && !(*size > 0 && *size <= kUiHeight)) fail("draw.text: size: above 0 and at most ", kUiHeight, " ui units expected, got ", number_text(*size));
  double x = 0, y = 0;
  if (!to_screen(camera_view(s.live_engine()), position, s.aspect, x, y)) return;
  DrawUi entry;
  entry.is_text = true;
  entry.text = {words, static_cast<float>(x), static_cast<float>(y), static_cast<float>(size.value_or(20)), color.value_or(Color{}), false};
  s.drawing().ui.push_back(entry);
}

}  // namespace

void rows_draw(Area& a) {
  a.fn<line>("line", "A line between two points.", "from", "to", "color");
  a.fn<arrow>("arrow", "An arrow from one point to another.", "from", "to", "color");
  a.fn<point>("point", "A small cross.", "position", "size", "color");
  a.fn<path>("path", "Lines through a list of points.", "points", "color").takes(0, "list of vec3");
  a.fn<shape>("shape", "The edges of a shape: \"box\", or a table as for a mesh; of a model its hull's.", "shape", "position", "rotation", "color").takes(0, "string or table");
  a.fn<world_text>("text", "Text at a place in the world; size is its line height in ui units (20).", "position", "text", "color", "size");
}

}  // namespace tumble
