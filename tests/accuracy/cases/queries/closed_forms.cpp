#include "accuracy/cases/queries/closed_forms.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

// The part of the line inside a convex shape, narrowed piece by piece; the normal is that of where it enters.
struct Inside {
  double enter = -INFINITY, leave = INFINITY;
  Vec3 normal;
  bool empty = false;

  void cut(double from, double to, Vec3 normal_from) {
    if (from > enter) {
      enter = from;
      normal = normal_from;
    }
    leave = std::min(leave, to);
  }
  std::optional<Meeting> first() const {
    if (empty || enter > leave || enter < 0) return {};
    return Meeting{enter, normal};
  }
};

// Where dot(normal, p) <= offset.
void cut_half_space(Inside& inside, const Line& line, Vec3 normal, double offset) {
  const double rate = dot(normal, line.direction), room = offset - dot(normal, line.origin);
  if (rate == 0) inside.empty |= room < 0;
  else if (rate < 0) inside.cut(room / rate, INFINITY, normal);
  else inside.cut(-INFINITY, room / rate, {});
}

// Roots of a t^2 + 2 b t + c with a > 0, without cancellation.
std::optional<std::pair<double, double>> roots(double a, double b, double c) {
  const double d = b * b - a * c;
  if (d < 0) return {};
  const double q = -(b + std::copysign(std::sqrt(d), b));
  const double x = q / a, y = q != 0 ? c / q : -x;
  return std::pair{std::min(x, y), std::max(x, y)};
}

// Far away, b^2 - a c loses its digits: the line is looked at from its nearest point instead.
Line nearby(const Line& line, double& shift) {
  shift = -dot(line.origin, line.direction);
  return {line.origin + line.direction * shift, line.direction};
}

std::optional<Meeting> meet_ball(Vec3 center, double radius, const Line& line) {
  const Vec3 to = line.origin - center;
  const auto t = roots(1, dot(to, line.direction), dot(to, to) - radius * radius);
  if (!t || t->first < 0) return {};
  return Meeting{t->first, (to + line.direction * t->first) / radius};
}

std::optional<Meeting> meet_box(Vec3 half, const Line& line) {
  Inside inside;
  for (const double sign : {-1.0, 1.0}) {
    cut_half_space(inside, line, {sign, 0, 0}, half.x);
    cut_half_space(inside, line, {0, sign, 0}, half.y);
    cut_half_space(inside, line, {0, 0, sign}, half.z);
  }
  return inside.first();
}

// Between the ends `half` apart from the middle; caps are flat.
std::optional<Meeting> meet_cylinder(double radius, double half, const Line& line) {
  Inside inside;
  cut_half_space(inside, line, {0, 1, 0}, half);
  cut_half_space(inside, line, {0, -1, 0}, half);
  const Vec3 o{line.origin.x, 0, line.origin.z}, d{line.direction.x, 0, line.direction.z};
  if (dot(d, d) < 1e-30) {
    inside.empty |= dot(o, o) > radius * radius;
  } else if (const auto t = roots(dot(d, d), dot(o, d), dot(o, o) - radius * radius)) {
    inside.cut(t->first, t->second, (o + d * t->first) / radius);
  } else {
    return {};
  }
  return inside.first();
}

// A cylinder without its caps counted, and two balls.
std::optional<Meeting> meet_capsule(double radius, double half, const Line& line) {
  std::optional<Meeting> side = meet_cylinder(radius, half, line);
  if (side && std::abs(side->normal.y) > 0.5) side.reset();
  return nearer(side, nearer(meet_ball({0, half, 0}, radius, line), meet_ball({0, -half, 0}, radius, line)));
}

// Apex up: x^2 + z^2 <= (k (h/2 - y))^2 with k = r/h, between y = -h/2 and h/2. The side is met from outside where the
// first root on the lower nappe lies; the base by its plane.
std::optional<Meeting> meet_cone(double radius, double height, const Line& line) {
  const double k = radius / height, top = height / 2;
  const Vec3 o = line.origin - Vec3{0, top, 0}, d = line.direction;
  std::optional<Meeting> best;
  const auto consider = [&](double t, Vec3 normal) {
    if (t >= 0 && dot(normal, d) < 0) best = nearer(best, Meeting{t, normal});
  };
  const double a = d.x * d.x + d.z * d.z - k * k * d.y * d.y, b = o.x * d.x + o.z * d.z - k * k * o.y * d.y;
  const double c = o.x * o.x + o.z * o.z - k * k * o.y * o.y;
  const auto side = [&](double t) {
    const Vec3 p = o + d * t;
    if (p.y <= 0 && p.y >= -height) consider(t, normalized(Vec3{p.x, -k * k * p.y, p.z}));
  };
  if (std::abs(a) < 1e-14) {
    if (b != 0) side(-c / (2 * b));
  } else if (const auto t = a > 0 ? roots(a, b, c) : roots(-a, -b, -c)) {
    side(t->first);
    side(t->second);
  }
  if (d.y != 0) {
    const double t = (-height - o.y) / d.y;
    const Vec3 p = o + d * t;
    if (p.x * p.x + p.z * p.z <= radius * radius) consider(t, {0, -1, 0});
  }
  return best;
}

std::optional<Meeting> meet_triangle(Vec3 a, Vec3 b, Vec3 c, const Line& line) {
  const Vec3 n = cross(b - a, c - a);
  const double rate = dot(n, line.direction);
  if (rate == 0) return {};
  const double t = dot(n, a - line.origin) / rate;
  const Vec3 p = line.origin + line.direction * t;
  const bool in = dot(n, cross(b - a, p - a)) >= 0 && dot(n, cross(c - b, p - b)) >= 0 && dot(n, cross(a - c, p - c)) >= 0;
  if (t < 0 || !in) return {};
  return Meeting{t, normalized(n) * (rate < 0 ? 1 : -1)};
}

std::optional<Meeting> meet_near(const Shape& shape, const Line& line) {
  switch (shape.shape) {
    case ShapeKind::box: return meet_box(shape.size / 2, line);
    case ShapeKind::sphere: return meet_ball({}, shape.radius, line);
    case ShapeKind::capsule: return meet_capsule(shape.radius, shape.height / 2 - shape.radius, line);
    case ShapeKind::cylinder: return meet_cylinder(shape.radius, shape.height / 2, line);
    case ShapeKind::cone: return meet_cone(shape.radius, shape.height, line);
    default: break;
  }
  std::optional<Meeting> best;
  for (std::size_t i = 0; i + 2 < shape.points.size(); i += 3)
    best = nearer(best, meet_triangle(shape.points[i], shape.points[i + 1], shape.points[i + 2], line));
  return best;
}

}  // namespace

std::optional<Meeting> nearer(std::optional<Meeting> a, std::optional<Meeting> b) {
  if (!a) return b;
  return b && b->distance < a->distance ? b : a;
}

// Shapes are some metres large: seen from 100 m before its nearest point the line has all its digits.
std::optional<Meeting> meet(const Shape& shape, const Line& line) {
  double shift = 0;
  Line near = nearby(line, shift);
  if (shift <= 100) return meet_near(shape, line);
  near.origin = near.origin - near.direction * 100;
  std::optional<Meeting> found = meet_near(shape, near);
  if (found) found->distance += shift - 100;
  return found;
}

std::optional<Meeting> meet_rounded_box(Vec3 size, double radius, const Line& line) {
  const Vec3 half = size / 2, r{radius, radius, radius};
  std::optional<Meeting> best;
  for (const Vec3 grow : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) best = nearer(best, meet_box(half + scaled(r, grow), line));
  // Its twelve edges, as capsules.
  const Pose turns[] = {{{}, between({0, 1, 0}, {1, 0, 0})}, {}, {{}, between({0, 1, 0}, {0, 0, 1})}};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 4; ++i) {
      const double u = i & 1 ? 1 : -1, v = i & 2 ? 1 : -1;
      const Vec3 middle = axis == 0 ? Vec3{0, u * half.y, v * half.z} : axis == 1 ? Vec3{u * half.x, 0, v * half.z} : Vec3{u * half.x, v * half.y, 0};
      const double reach = axis == 0 ? half.x : axis == 1 ? half.y : half.z;
      best = nearer(best, at({middle, turns[axis].rotation}, [&](const Line& l) { return meet_capsule(radius, reach, l); })(line));
    }
  return best;
}

Truth at(const Pose& pose, Truth truth) {
  return [pose, truth = std::move(truth)](const Line& line) {
    const Pose back = inverse(pose);
    std::optional<Meeting> found = truth({back * line.origin, back.rotation * line.direction});
    if (found) found->normal = pose.rotation * found->normal;
    return found;
  };
}

}  // namespace tumble::accuracy
