#include "app/debug_pen.h"

#include <algorithm>

#include "app/error_screen.h"
#include "engine/extract.h"
#include "render/renderer.h"

namespace tumble {

namespace {

constexpr double kHidden = 0.25;  // opacity of what lies behind something

std::array<float, 3> floats(Vec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

// Some direction across another one.
Vec3 across(Vec3 way) { return normalized(cross(way, std::abs(way.y) < 0.9 * length(way) ? Vec3{0, 1, 0} : Vec3{1, 0, 0})); }

}  // namespace

void DebugPen::line(Vec3 from, Vec3 to, const Color& color, bool on_top) {
  list_.lines.push_back({floats(from - list_.origin), floats(to - list_.origin), color, on_top});
}

void DebugPen::arrow(Vec3 from, Vec3 to, const Color& color) {
  const Vec3 way = to - from, side = across(way) * (0.06 * length(way));
  line(from, to, color);
  line(to, to - way * 0.15 + side, color);
  line(to, to - way * 0.15 - side, color);
}

void DebugPen::cross(Vec3 at, double size, const Color& color) {
  for (const Vec3 e : {Vec3{size, 0, 0}, Vec3{0, size, 0}, Vec3{0, 0, size}}) line(at - e, at + e, color);
}

void DebugPen::arc(Vec3 center, Vec3 u, Vec3 v, double angle, const Color& color) {
  Wire wire;
  add_arc(wire, center, u, v, angle);
  for (const WireLine& part : wire) line(part.from, part.to, color);
}

void DebugPen::wire(const Wire& wire, const Pose& pose, const Color& color) {
  const Color hidden{color.r, color.g, color.b, color.a * kHidden};
  const Vec3 shift = pose.position - list_.origin;
  const Vec3 x = pose.rotation * Vec3{1, 0, 0}, y = pose.rotation * Vec3{0, 1, 0}, z = pose.rotation * Vec3{0, 0, 1};
  const auto place = [&](Vec3 p) { return floats(shift + x * p.x + y * p.y + z * p.z); };
  for (const WireLine& part : wire) {
    const auto from = place(part.from), to = place(part.to);
    list_.lines.push_back({from, to, color, false});
    list_.lines.push_back({from, to, hidden, true});
  }
}

void DebugPen::label(Vec3 at, const std::string& text, const Color& color) {
  constexpr double size = 16;
  double x = 0, y = 0;
  const CameraView view{{list_.origin, list_.camera_rotation}, list_.field_of_view, list_.near, list_.far};
  if (!to_screen(view, at, aspect_, x, y)) return;
  const double width = measure_text(text, size).width;
  add_panel(list_, x - width / 2 - 3, y - size, width + 6, size, {0, 0, 0, 0.5});
  add_text(list_, text, x - width / 2, y - size, size, color);
}

// ---- joints

namespace {

const Color kLink{1, 1, 0.3, 1}, kRange{1, 0.6, 0.15, 1}, kNeedle{1, 1, 1, 1};
const Color kAxis{1, 0.25, 0.2, 1}, kSide{0.35, 0.9, 0.35, 1}, kOther{0.35, 0.55, 1, 1};

void draw_frame(DebugPen& pen, const Pose& frame, double size) {
  pen.line(frame.position, frame * Vec3{size, 0, 0}, kAxis);
  pen.line(frame.position, frame * Vec3{0, size * 0.5, 0}, kSide);
  pen.line(frame.position, frame * Vec3{0, 0, size * 0.5}, kOther);
}

struct JointView {
  Pose a, b;      // the joint's frame as each body has it, world
  double size;    // m, of what is drawn
};

void draw_kind(DebugPen&, const FixedDef&, const JointView&) {}

// A small ball, since it turns all ways.
void draw_kind(DebugPen& pen, const BallDef&, const JointView& view) {
  const double r = view.size * 0.4;
  for (const auto& [u, v] : {std::pair(Vec3{r, 0, 0}, Vec3{0, r, 0}), std::pair(Vec3{0, r, 0}, Vec3{0, 0, r}), std::pair(Vec3{0, 0, r}, Vec3{r, 0, 0})})
    pen.arc(view.b.position, view.b.rotation * u, view.b.rotation * v, 2 * kPi, kRange);
}

// The angles it may take as an arc, from where 0 and a quarter turn point to.
void draw_range(DebugPen& pen, const TurnDef& turn, Vec3 center, Vec3 zero, Vec3 quarter) {
  const auto at = [&](double angle) { return zero * std::cos(angle) + quarter * std::sin(angle); };
  const bool limited = turn.min && turn.max && *turn.max - *turn.min < 2 * kPi;
  const double low = limited ? *turn.min : 0, high = limited ? *turn.max : 2 * kPi;
  pen.arc(center, at(low), at(low + kPi / 2), high - low, kRange);
  for (const auto& limit : {turn.min, turn.max})
    if (limit) pen.line(center, center + at(*limit), kRange);
}

// The range from b's side direction; the needle is a's.
void draw_kind(DebugPen& pen, const HingeDef& hinge, const JointView& view) {
  const double r = view.size;
  draw_range(pen, hinge.angle, view.b.position, view.b.rotation * Vec3{0, r, 0}, view.b.rotation * Vec3{0, 0, r});
  pen.arrow(view.b.position, view.b.position + view.a.rotation * Vec3{0, r, 0}, kNeedle);
}

// Its way as a line with ends; the cross is where it is.
void draw_kind(DebugPen& pen, const SliderDef& slider, const JointView& view) {
  const double low = slider.position.min.value_or(-2 * view.size), high = slider.position.max.value_or(2 * view.size);
  const auto at = [&](double x, double y) { return view.b * Vec3{x, y, 0}; };
  pen.line(at(low, 0), at(high, 0), kRange);
  const double end = view.size * 0.3;
  for (const auto& limit : {slider.position.min, slider.position.max})
    if (limit) pen.line(at(*limit, -end), at(*limit, end), kRange);
  pen.cross(view.a.position, view.size * 0.15, kNeedle);
}

// Its way, and at a's place the range of turns.
void draw_kind(DebugPen& pen, const CylindricalDef& cylindrical, const JointView& view) {
  draw_kind(pen, SliderDef{cylindrical.slide}, view);
  draw_kind(pen, HingeDef{cylindrical.turn}, JointView{view.a, {view.a.position, view.b.rotation}, view.size * 0.5});
}

// The arms of the cross are needles: a's in b's range and b's in a's.
void draw_kind(DebugPen& pen, const UniversalDef& universal, const JointView& view) {
  const double r = view.size;
  const Vec3 at = view.b.position;
  draw_range(pen, universal.turn_a, at, view.a.rotation * Vec3{0, r, 0}, view.a.rotation * Vec3{0, 0, -r});
  draw_range(pen, universal.turn_b, at, view.b.rotation * Vec3{r, 0, 0}, view.b.rotation * Vec3{0, 0, -r});
  pen.arrow(at, at + view.a.rotation * Vec3{r, 0, 0}, kNeedle);
  pen.arrow(at, at + view.b.rotation * Vec3{0, r, 0}, kNeedle);
}

// The cone that the bone may point into; the needle is the bone.
void draw_kind(DebugPen& pen, const RagdollDef& ragdoll, const JointView& view) {
  const double r = view.size;
  const Vec3 tip = view.b.position;
  pen.arrow(tip, tip + view.a.rotation * Vec3{r, 0, 0}, kNeedle);
  if (!ragdoll.swing_a.max || !ragdoll.swing_b.max) return;
  const auto at = [&](int i) {
    const double angle = i * kPi / 24;
    const Vec3 swing{0, *ragdoll.swing_a.max * std::cos(angle), *ragdoll.swing_b.max * std::sin(angle)};
    return tip + view.b.rotation * (axis_angle(swing, length(swing)) * Vec3{r, 0, 0});
  };
  for (int i = 0; i < 48; ++i) {
    pen.line(at(i), at(i + 1), kRange);
    if (i % 6 == 0) pen.line(tip, at(i), kRange);
  }
}

}  // namespace

void draw_joint(DebugPen& pen, const DebugJoint& joint, const std::function<Pose(BodyId)>& pose_of) {
  const Pose a = pose_of(joint.a), b = pose_of(joint.b);
  JointView view{a * joint.local_a, b * joint.local_b, 0};
  const Vec3 center_a = a * joint.center_a, center_b = b * joint.center_b;
  const double reach = std::max(distance(center_a, view.a.position), distance(center_b, view.b.position));
  view.size = std::clamp(reach / 2, 0.1, 1.0);
  pen.line(center_a, view.a.position, kLink);
  pen.line(center_b, view.b.position, kLink);
  draw_frame(pen, view.a, view.size * 0.5);
  std::visit([&](const auto& kind) { draw_kind(pen, kind, view); }, *joint.kind);
}

}  // namespace tumble
