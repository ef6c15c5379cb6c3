// The world as lines: shapes by their circles and edges.
#include "physics/bullet/impl.h"
#include "physics/solids.h"

namespace tumble {

namespace {

const Color kAwake{1, 0.65, 0}, kAsleep{0.55, 0.55, 0.6}, kStatic{0.35, 0.8, 0.4}, kKinematic{0.4, 0.65, 1}, kTrigger{0.85, 0.4, 0.95};
const Color kJoint{1, 1, 0.3}, kBox{0.5, 0.5, 0.5}, kContact{1, 0.2, 0.2};

class Pen {
 public:
  Pen(const Pose& pose, Color color, std::vector<DebugLine>& lines) : pose_(pose), color_(color), lines_(lines) {}

  void line(Vec3 a, Vec3 b) { lines_.push_back({pose_ * a, pose_ * b, color_}); }
  // An arc about `center` from u towards v, both as long as its radius.
  void arc(Vec3 center, Vec3 u, Vec3 v, double angle = 2 * kPi) {
    const int parts = angle > 4 ? 24 : 12;
    for (int i = 0; i < parts; ++i) {
      const double a = angle * i / parts, b = angle * (i + 1) / parts;
      line(center + u * std::cos(a) + v * std::sin(a), center + u * std::cos(b) + v * std::sin(b));
    }
  }
  void ring(double y, double r) { arc({0, y, 0}, {r, 0, 0}, {0, 0, r}); }
  void sides(double low, double r_low, double high, double r_high) {
    for (const Vec3 out : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}})
      line(out * r_low + Vec3{0, low, 0}, out * r_high + Vec3{0, high, 0});
  }

 private:
  Pose pose_;
  Color color_;
  std::vector<DebugLine>& lines_;
};

void draw_box(Vec3 half, Pen& pen) {
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0}) {
      pen.line({-half.x, a * half.y, b * half.z}, {half.x, a * half.y, b * half.z});
      pen.line({a * half.x, -half.y, b * half.z}, {a * half.x, half.y, b * half.z});
      pen.line({a * half.x, b * half.y, -half.z}, {a * half.x, b * half.y, half.z});
    }
}

void draw_capsule(double r, double half_axis, Pen& pen) {
  for (const double sign : {-1.0, 1.0}) {
    const Vec3 center{0, sign * half_axis, 0}, up{0, sign * r, 0};
    pen.ring(center.y, r);
    pen.arc(center, {r, 0, 0}, up, kPi);
    pen.arc(center, {0, 0, r}, up, kPi);
  }
  pen.sides(-half_axis, r, half_axis, r);
}

void draw_triangles(const std::vector<Triangle>& triangles, Pen& pen) {
  for (const Triangle& t : triangles) {
    pen.line(t.a, t.b);
    pen.line(t.b, t.c);
    pen.line(t.c, t.a);
  }
}

void draw_torus(const Shape& torus, Pen& pen) {
  const double r = torus.thickness / 2;
  pen.ring(0, torus.radius + r);
  pen.ring(0, torus.radius - r);
  pen.ring(r, torus.radius);
  pen.ring(-r, torus.radius);
  for (int i = 0; i < 8; ++i) {
    const Vec3 out{std::cos(kPi * i / 4), 0, std::sin(kPi * i / 4)};
    pen.arc(out * torus.radius, out * r, {0, r, 0});
  }
}

void draw_shape(const Shape& shape, Pen& pen) {
  const double r = shape.radius, h = shape.height / 2;
  switch (shape.shape) {
    case ShapeKind::box: return draw_box(shape.size / 2, pen);
    case ShapeKind::sphere:
      pen.ring(0, r);
      pen.arc({}, {r, 0, 0}, {0, r, 0});
      return pen.arc({}, {0, 0, r}, {0, r, 0});
    case ShapeKind::capsule: return draw_capsule(r, std::max(0.0, h - r), pen);
    case ShapeKind::cylinder:
      pen.ring(h, r);
      pen.ring(-h, r);
      return pen.sides(-h, r, h, r);
    case ShapeKind::cone:
      pen.ring(-h, r);
      return pen.sides(-h, r, h, 0);
    case ShapeKind::pyramid: return draw_triangles(convex_hull(pyramid_points(shape)), pen);
    case ShapeKind::plane: return draw_box({shape.size.x / 2, 0, shape.size.z / 2}, pen);
    case ShapeKind::torus: return draw_torus(shape, pen);
    case ShapeKind::hull: return draw_triangles(convex_hull(shape.points), pen);
    case ShapeKind::mesh:
    case ShapeKind::height_field:
      for (std::size_t i = 0; i + 2 < shape.points.size(); i += 3)
        draw_triangles({{shape.points[i], shape.points[i + 1], shape.points[i + 2]}}, pen);
  }
}

Color color_of(const BodyState& body) {
  if (body.def.type == BodyType::fixed) return kStatic;
  if (body.def.type == BodyType::kinematic) return kKinematic;
  return body.awake() ? kAwake : kAsleep;
}

void draw_colliders(const BodyState& body, std::vector<DebugLine>& lines) {
  const Pose pose = body.pose();
  for (const ColliderDef& collider : body.def.colliders) {
    const bool trigger = collider.trigger.value_or(body.def.trigger);
    Pen pen(pose * Pose{collider.offset, normalized(collider.rotation)}, trigger ? kTrigger : color_of(body), lines);
    draw_shape(collider.shape, pen);
  }
}

void draw_bounds(const BodyState& body, std::vector<DebugLine>& lines) {
  if (body.solids->empty()) return;
  btVector3 low, high;
  body.rigid->getAabb(low, high);
  Pen pen({from_bullet((low + high) / 2), {}}, kBox, lines);
  draw_box(from_bullet((high - low) / 2), pen);
}

void draw_joint(const JointPart& joint, std::vector<DebugLine>& lines) {
  const JointFrame frame = joint.frame();
  const Vec3 axis = frame.b.rotation * Vec3{0.25, 0, 0};
  lines.push_back({frame.a.position - axis, frame.a.position + axis, kJoint});
  if (joint.a) lines.push_back({frame.center_a, frame.a.position, kJoint});
  if (joint.b) lines.push_back({frame.center_b, frame.b.position, kJoint});
}

}  // namespace

void World::debug_lines(const DebugOptions& options, std::vector<DebugLine>& lines) const {
  impl_->bodies.each([&](BodyId, const Body& body) {
    if (!body.state->enabled) return;
    if (options.colliders) draw_colliders(*body.state, lines);
    if (options.boxes) draw_bounds(*body.state, lines);
  });
  if (options.joints)
    for (const JointPart* joint : impl_->live) draw_joint(*joint, lines);
  if (!options.contacts) return;
  for (const auto& pair : impl_->book.pairs())
    for (const ContactPoint& point : pair->event.points)
      lines.push_back({point.point, point.point + pair->event.normal * 0.2, kContact});
}

}  // namespace tumble
