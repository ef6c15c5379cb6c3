#include "app/debug_view.h"

#include <algorithm>
#include <array>

#include "app/debug_pen.h"
#include "app/error_screen.h"
#include "base/text.h"
#include "render/renderer.h"

namespace tumble {

namespace {

// By DebugState, then triggers.
const std::array<Color, 5> kColors = {Color{1, 0.65, 0, 1}, {0.62, 0.62, 0.68, 1}, {0.4, 0.65, 1, 1}, {0.35, 0.85, 0.4, 1}, {0.9, 0.4, 0.95, 1}};
const std::array<const char*, 5> kStates = {"awake", "asleep", "kinematic", "static", "trigger"};
constexpr std::size_t kTrigger = 4;
const Color kContact{1, 0.25, 0.2, 1}, kRay{1, 1, 0.2, 1}, kBeyond{0.6, 0.6, 0.6, 0.5}, kVelocity{0.2, 0.95, 1, 1}, kTurning{1, 0.45, 0.9, 1};

constexpr double kVelocitySeconds = 0.2;   // an arrow ends where the body would be after so long
constexpr double kTurningScale = 0.1;      // m for 1 rad/s
constexpr double kForceScale = 0.1;        // m for the square root of 1 N: grams and tons are seen in one picture

// What a view shows; and what its signs mean, for the corner of the screen.
struct Parts {
  bool colliders = false, joints = false, boxes = false, contacts = false, rays = false, velocities = false, names = false;
};
Parts parts_of(DebugView view) {
  const bool all = view == DebugView::physics;
  Parts parts;
  parts.colliders = all || view == DebugView::colliders;
  parts.joints = all || view == DebugView::joints;
  parts.boxes = view == DebugView::boxes;
  parts.contacts = all || view == DebugView::contacts;
  parts.rays = all || view == DebugView::rays;
  parts.velocities = all || view == DebugView::velocities;
  parts.names = view == DebugView::names;
  return parts;
}

struct Overlay {
  const Engine& engine;
  DebugPen pen;
  double alpha;
  std::array<int, 5> counts{};

  Pose pose_of(BodyId body) const {
    const NodeId node = body ? engine.node_of(body) : NodeId{};
    if (!node) return {};
    const Transform place = engine.scene.interpolated_world(node, alpha);
    return {place.position, place.rotation};
  }

  void draw_body(const DebugBody& body, const Parts& parts) {
    const std::size_t state = body.solids->empty() && !body.triggers->empty() ? kTrigger : static_cast<std::size_t>(body.state);
    ++counts[state];
    if (parts.boxes) draw_box(body, kColors[state]);
    if (!parts.colliders && !parts.velocities && !parts.names) return;
    const Pose pose = pose_of(body.body);
    if (parts.colliders) {
      pen.wire(*body.solids, pose, kColors[static_cast<std::size_t>(body.state)]);
      pen.wire(*body.triggers, pose, kColors[kTrigger]);
    }
    if (parts.velocities) draw_velocity(body, pose);
    if (parts.names) pen.label(pose.position + Vec3{0, (body.high.y - body.low.y) / 2, 0}, label(engine.scene[engine.node_of(body.body)]), kColors[state]);
  }

  void draw_box(const DebugBody& body, const Color& color) {
    Shape box;
    box.size = body.high - body.low;
    pen.wire(wire_of(box), {(body.low + body.high) / 2, {}}, color);
  }

  void draw_velocity(const DebugBody& body, const Pose& pose) {
    if (body.state != DebugState::awake && body.state != DebugState::kinematic) return;
    const Vec3 center = pose * body.center;
    if (length(body.velocity) > 0.01) pen.arrow(center, center + body.velocity * kVelocitySeconds, kVelocity);
    if (length(body.angular_velocity) > 0.01) pen.arrow(center, center + body.angular_velocity * kTurningScale, kTurning);
  }

  // Points with the mean force of the tick along the normal, pushing b.
  void draw_contact(const ContactEvent& contact, double tick_seconds, bool numbers) {
    for (const ContactPoint& point : contact.points) {
      pen.cross(point.point, 0.03, kContact);
      const double force = std::max(0.0, point.impulse / tick_seconds);
      pen.line(point.point, point.point + contact.normal * (kForceScale * std::sqrt(force)), kContact);
    }
    if (numbers) pen.label(contact.point, number_text(std::round(contact.impulse * 1000) / 1000) + " N s", {1, 0.8, 0.75, 1});
  }

  void draw_query(const DebugQuery& query) {
    const bool stopped = query.stop < distance(query.from, query.to);
    const Vec3 way = normalized(query.to - query.from), end = query.from + way * query.stop;
    pen.line(query.from, stopped ? end : query.to, kRay);
    if (stopped) pen.line(end, query.to, kBeyond);
    if (query.shape) {
      const Wire wire = wire_of(*query.shape);
      pen.wire(wire, {query.from, {}}, kRay);
      if (end != query.from) pen.wire(wire, {end, {}}, kRay);
    }
    for (const auto& [point, normal] : query.hits) {
      pen.cross(point, 0.05, kContact);
      pen.arrow(point, point + normal * 0.3, kContact);
    }
  }
};

// ---- the corner of the screen

struct Row {
  std::string text;
  Color color{1, 1, 1, 1};
  bool swatch = false;   // a square of the color before it
};

std::vector<Row> legend(DebugView view, const Parts& parts, const std::array<int, 5>& counts) {
  std::vector<Row> rows = {{"debug view: " + enum_names(DebugView{})[static_cast<std::size_t>(view)]}};
  if (parts.colliders || parts.boxes || parts.names)
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (counts[i] > 0) rows.push_back({std::string(kStates[i]) + "  " + std::to_string(counts[i]), kColors[i], true});
  if (parts.joints) rows.push_back({"joints and their limits", {1, 0.6, 0.15, 1}, true});
  if (parts.contacts) rows.push_back({"contacts: the root of the force, 1 m for 100 N", kContact, true});
  if (parts.rays) rows.push_back({"rays and casts of this tick", kRay, true});
  if (parts.velocities) {
    rows.push_back({"velocity: the way of 0.2 s", kVelocity, true});
    rows.push_back({"turning: 1 m for 10 rad/s", kTurning, true});
  }
  return rows;
}

void add_rows(DrawList& list, const std::vector<Row>& rows, double aspect) {
  constexpr double size = 17, margin = 12, indent = 16;
  double width = 0;
  for (const Row& row : rows) width = std::max(width, measure_text(row.text, size).width + (row.swatch ? indent : 0));
  const double height = size * static_cast<double>(rows.size());
  const double x = kUiHeight * aspect - margin - width - 16;
  double y = kUiHeight - margin - height - 12;
  add_panel(list, x, y, width + 16, height + 12, {0, 0, 0, 0.55});
  y += 6;
  for (const Row& row : rows) {
    if (row.swatch) add_panel(list, x + 8, y + 4, 10, 10, row.color);
    add_text(list, row.text, x + 8 + (row.swatch ? indent : 0), y, size, {0.95, 0.95, 0.95, 1});
    y += size;
  }
}

std::string cost_text(const WorldStats& stats) {
  const auto some = [](int count, const char* one, const char* more) { return std::to_string(count) + ' ' + (count == 1 ? one : more); };
  return some(stats.bodies, "body", "bodies") + ", " + some(stats.joints, "joint", "joints") + ", " + some(stats.contacts, "contact", "contacts") + "; " +
         some(stats.islands, "island", "islands") + ", up to " + some(stats.substeps, "substep", "substeps") + ": " + number_text(std::round(stats.step_ms * 100) / 100) + " ms a tick";
}

}  // namespace

void add_debug_view(DrawList& list, const Engine& engine, DebugView view, const std::vector<DebugQuery>& queries, double alpha,
                    double aspect, double dropped_seconds) {
  if (view == DebugView::none) return;
  const Parts parts = parts_of(view);
  const World* world = engine.world();
  std::array<int, 5> counts{};
  if (world) {
    Overlay overlay{engine, DebugPen(list, aspect), alpha};
    world->each_debug_body([&](const DebugBody& body) { overlay.draw_body(body, parts); });
    counts = overlay.counts;
    if (parts.joints)
      world->each_debug_joint([&](const DebugJoint& joint) { draw_joint(overlay.pen, joint, [&](BodyId body) { return overlay.pose_of(body); }); });
    if (parts.contacts)
      world->each_contact([&](const ContactEvent& contact) {
        overlay.draw_contact(contact, 1 / engine.settings.tick_rate, view == DebugView::contacts);
      });
    if (parts.rays)
      for (const DebugQuery& query : queries) overlay.draw_query(query);
  }
  std::vector<Row> rows = legend(view, parts, counts);
  rows.push_back({world ? cost_text(world->stats()) : "no bodies in this game yet"});
  if (dropped_seconds > 0) rows.push_back({number_text(std::round(dropped_seconds * 100) / 100) + " s dropped: the computer was too slow for them", {1, 0.6, 0.3, 1}});
  rows.push_back({"F3: next", {0.8, 0.8, 0.8, 1}});
  add_rows(list, rows, aspect);
}

}  // namespace tumble
