#include "accuracy/scenes.h"

namespace tumble::accuracy {

Shape box(Vec3 size) {
  Shape shape;
  shape.shape = ShapeKind::box;
  shape.size = size;
  return shape;
}

Shape ball(double radius) {
  Shape shape;
  shape.shape = ShapeKind::sphere;
  shape.radius = radius;
  return shape;
}

Shape upright(ShapeKind kind, double radius, double height) {
  Shape shape;
  shape.shape = kind;
  shape.radius = radius;
  shape.height = height;
  return shape;
}

Shape hull(std::vector<Vec3> points) {
  Shape shape;
  shape.shape = ShapeKind::hull;
  shape.points = std::move(points);
  return shape;
}

namespace {

BodyDef body(const Shape& shape, BodyType type, double surface) {
  BodyDef def;
  def.type = type;
  def.colliders.emplace_back();
  def.colliders.back().shape = shape;
  def.friction = surface;
  def.restitution = surface;
  return def;
}

}  // namespace

BodyDef dynamic(const Shape& shape, double mass) {
  BodyDef def = body(shape, BodyType::dynamic, 0);
  def.mass = mass;
  return def;
}
BodyDef fixed(const Shape& shape) { return body(shape, BodyType::fixed, 1); }
BodyDef kinematic(const Shape& shape) { return body(shape, BodyType::kinematic, 1); }

BodyDef with(BodyDef def, double friction, double restitution) {
  def.friction = friction;
  def.restitution = restitution;
  return def;
}

BodyIndex add_floor(Simulation& scene, double side) { return scene.add(fixed(box({side, 2, side})), {{0, -1, 0}, {}}); }

JointSpec joint(BodyIndex a, BodyIndex b, Vec3 anchor, const JointKind& kind, Vec3 axis) {
  JointSpec spec;
  spec.a = a;
  spec.b = b;
  spec.def.anchor = anchor;
  spec.def.axis = axis;
  spec.def.kind = kind;
  return spec;
}

void run(Simulation& scene, double seconds, double frame) {
  run(scene, seconds, frame, [](double) { return true; });
}

void run(Simulation& scene, double seconds, double frame, const std::function<bool(double)>& each) {
  const long count = std::lround(seconds / frame);
  for (long i = 1; i <= count; ++i) {
    scene.step(frame);
    if (!each(static_cast<double>(i) * frame)) return;
  }
}

namespace {

// The axes in which the inertia is diagonal, in the world.
Quat principal(const Simulation& scene, BodyIndex body, const MassProperties& mass) { return scene.pose(body).rotation * mass.axes; }

}  // namespace

Vec3 center(const Simulation& scene, BodyIndex body) { return scene.pose(body) * scene.mass_properties(body).center; }

Vec3 momentum(const Simulation& scene, BodyIndex body) { return scene.velocity(body) * scene.mass_properties(body).mass; }

Vec3 spin_momentum(const Simulation& scene, BodyIndex body) {
  const MassProperties mass = scene.mass_properties(body);
  const Quat axes = principal(scene, body, mass);
  return axes * scaled(mass.inertia, conjugate(axes) * scene.angular_velocity(body));
}

Vec3 angular_momentum(const Simulation& scene, BodyIndex body) {
  return spin_momentum(scene, body) + cross(center(scene, body), momentum(scene, body));
}

double kinetic_energy(const Simulation& scene, BodyIndex body) {
  return 0.5 * dot(momentum(scene, body), scene.velocity(body)) + 0.5 * dot(spin_momentum(scene, body), scene.angular_velocity(body));
}

double energy(const Simulation& scene, BodyIndex body, Vec3 gravity) {
  return kinetic_energy(scene, body) - scene.mass_properties(body).mass * dot(gravity, center(scene, body));
}

bool finite(const Simulation& scene, BodyIndex body) {
  const Pose pose = scene.pose(body);
  return is_finite(pose.position) && is_finite(pose.rotation) && is_finite(scene.velocity(body)) && is_finite(scene.angular_velocity(body));
}

double fastest_corner(const Simulation& scene, BodyIndex body, Vec3 size) {
  const Quat rotation = scene.pose(body).rotation;
  double speed = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = scaled(size / 2, {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    speed = std::max(speed, length(scene.velocity(body) + cross(scene.angular_velocity(body), rotation * corner)));
  }
  return speed;
}

// Steele, Lea, Flood: SplitMix64.
double Chance::unit() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

Vec3 Chance::direction() {
  for (;;) {
    const Vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
    const double l = length(v);
    if (l > 1e-3 && l <= 1) return v / l;
  }
}

Quat Chance::rotation() {
  for (;;) {
    const Quat q{between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)};
    const double l = length(q);
    if (l > 1e-3 && l <= 1) return normalized(q);
  }
}

void Spread::add(double value) {
  sum += value;
  low = std::min(low, value);
  high = std::max(high, value);
  ++count;
}

}  // namespace tumble::accuracy
