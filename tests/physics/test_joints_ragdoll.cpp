#include "joint_bench.h"

#include "physics/joints/ellipse.h"

using namespace tumble;

namespace {

JointRows rows_at(Quat a, Quat b, const RagdollDef& def) {
  JointRows out;
  rows(def, JointFrame{{{}, a}, {{}, b}, {}, {}}, out);
  return out;
}

Quat turned_by(Vec3 spin, double h, Quat q) { return axis_angle(spin, length(spin) * h) * q; }

RagdollDef cone(double a, double b) {
  RagdollDef def;
  def.swing_a.max = a;
  def.swing_b.max = b;
  return def;
}

// A rod that hangs from the world at its upper end, or stands out from it along x; its axis goes along it, away from the
// joint, and swing_a is about z.
struct Bone {
  explicit Bone(const RagdollDef& kind, const WorldSettings& settings = {}) : scene(settings) {
    BodyDef def = body(box({0.1, 1, 0.1}));
    def.mass = 2;
    def.can_sleep = false;
    bone = scene.add(def, {0, -0.5, 0});
    JointDef joined;
    joined.a = bone;
    joined.anchor = {0, 0.5, 0};
    joined.axis = {0, -1, 0};
    RagdollDef its = kind;
    its.swing_axis = Vec3{0, 0, 1};
    joined.kind = its;
    joint = scene.world.add(joined, 0);
  }
  // Starts it turning about its joint.
  void spin(Vec3 w) {
    scene.world.set_angular_velocity(bone, w);
    scene.world.set_velocity(bone, cross(w, {0, -0.5, 0}));
  }
  double at(std::size_t freedom) const { return scene.world.state(joint).freedoms.at(freedom).position; }
  Scene scene;
  BodyId bone;
  JointId joint;
};

constexpr double kBoneInertia = 2 * (1 + 0.01) / 12 + 2 * 0.25, kBoneTwist = 2 * 0.02 / 12;

}  // namespace

TEST_CASE("ragdoll: the nearest boundary of an ellipse is the nearest of many points of it", "[physics]") {
  for (const auto& [p, q] : {std::pair{1.0, 0.4}, {0.3, 1.2}, {0.7, 0.7}, {1.5, 0.01}})
    for (const Vec3 at :
         {Vec3{0.2, 0.1, 0}, Vec3{-0.5, 0.3, 0}, Vec3{0.9, 0, 0}, Vec3{0, -0.5, 0}, Vec3{},
          Vec3{1, -1, 0}, Vec3{1e-9, 1e-9, 0}, Vec3{0.95, 1e-17, 0}, Vec3{0.01, 0, 0}}) {
      double nearest = INFINITY;
      for (int i = 0; i < 200000; ++i) {
        const double t = i * 2 * kPi / 200000;
        nearest = std::min(nearest, std::hypot(p * std::cos(t) - at.x, q * std::sin(t) - at.y));
      }
      const bool out = std::pow(at.x / p, 2) + std::pow(at.y / q, 2) > 1;

      const Boundary found = ellipse_boundary(p, q, at.x, at.y);

      INFO(p << ' ' << q << " at " << at.x << ' ' << at.y);
      CHECK(found.inside == Approx(out ? -nearest : nearest).margin(1e-5));
      const double x = (at.x + found.normal_a * found.inside) / p, y = (at.y + found.normal_b * found.inside) / q;
      CHECK(x * x + y * y == Approx(1).margin(1e-9));
    }
}

TEST_CASE("ragdoll: a twist and then a swing are read back", "[physics]") {
  const Quat b = axis_angle({1, 2, 3}, 0.8);
  for (const Vec3 swing : {Vec3{}, Vec3{0, 0.3, 0}, Vec3{0, -1.1, 0.8}, Vec3{0, 1e-6, -2e-6}, Vec3{0, 2, -2}})
    for (const double twist : {-3.0, -0.5, 0.0, 1.7}) {
      const Quat swung = length(swing) > 0 ? axis_angle(swing, length(swing)) : Quat{};

      const JointRows rows = rows_at(b * swung * axis_angle({1, 0, 0}, twist), b, {});

      CHECK(rows.free[0].position == Approx(swing.y).margin(1e-12));
      CHECK(rows.free[1].position == Approx(swing.z).margin(1e-12));
      CHECK(rows.free[2].position == Approx(twist).margin(1e-12));
    }
}

TEST_CASE("ragdoll: a row's velocity is the rate of what it measures", "[physics]") {
  constexpr double h = 1e-5;
  const Quat b = axis_angle({-1, 2, 0.5}, 1.1);
  for (const Vec3 swing : {Vec3{0, 1e-3, 2e-3}, Vec3{0, 0.3, 0.1}, Vec3{0, -1.1, 0.8}, Vec3{0, 1.4, -1.4}}) {
    const Quat a = b * axis_angle(swing, length(swing)) * axis_angle({1, 0, 0}, 0.9);
    const Vec3 spin_a{0.9, -0.4, 1.5}, spin_b{-0.7, 0.8, 0.2};
    const RagdollDef def = cone(0.9, 0.5);
    const JointRows now = rows_at(a, b, def);
    const JointRows later = rows_at(turned_by(spin_a, h, a), turned_by(spin_b, h, b), def);
    const JointRows before = rows_at(turned_by(spin_a, -h, a), turned_by(spin_b, -h, b), def);

    REQUIRE(now.free.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      const double rate = dot(now.free[i].row.angular_a, spin_a) + dot(now.free[i].row.angular_b, spin_b);
      INFO(i << " at " << swing.y << ' ' << swing.z);
      CHECK(rate == Approx((later.free[i].position - before.free[i].position) / (2 * h)).epsilon(1e-7).margin(1e-7));
    }
  }
}

TEST_CASE("ragdoll: a bone swings no further than its cone, whichever way", "[physics]") {
  double worst = 0;
  for (int way = 0; way < 16; ++way)
    for (const double speed : {2.0, 6.0}) {
      Bone bone(cone(0.8, 0.4));
      const double angle = way * kPi / 8;
      bone.spin({speed * std::sin(angle), 0, speed * std::cos(angle)});
      double reached = INFINITY;
      for (int i = 0; i < 240; ++i) {
        bone.scene.world.step(kTick);
        const double inside = ellipse_boundary(0.8, 0.4, bone.at(0), bone.at(1)).inside;
        reached = std::min(reached, inside);
        worst = std::min(worst, inside);
      }
      CHECK(reached < 0.4);
    }
  INFO("worst " << worst);
  CHECK(worst > -1e-3);
}

TEST_CASE("ragdoll: a bone that slides round in its cone neither leaves it nor loses speed", "[physics]") {
  Bone bone(cone(0.5, 0.5), weightless());
  const Vec3 along{std::sin(0.5), -std::cos(0.5), 0}, w = cross(along, {0, 0, 1}) * 5;
  bone.scene.world.teleport(bone.bone, {along * 0.5, axis_angle({0, 0, 1}, 0.5)});
  bone.scene.world.set_angular_velocity(bone.bone, w);
  bone.scene.world.set_velocity(bone.bone, cross(w, along * 0.5));

  double furthest = 0, turned = 0;
  for (int i = 0; i < 300; ++i) {
    const double before = std::atan2(bone.at(1), bone.at(0));
    bone.scene.world.step(kTick);
    turned += std::remainder(std::atan2(bone.at(1), bone.at(0)) - before, 2 * kPi);
    furthest = std::max(furthest, std::hypot(bone.at(0), bone.at(1)));
  }

  CHECK(length(bone.scene.world.velocity(bone.bone)) == Approx(2.5).epsilon(1e-3));
  CHECK(std::abs(turned) == Approx(5 * 5 / std::sin(0.5)).epsilon(1e-2));  // along a circle of sin(0.5)
  CHECK(furthest < 0.5 + 1e-3);
}

TEST_CASE("ragdoll: a bone pushed against its cone rests at it", "[physics]") {
  for (const auto& [torque, freedom, limit] : {std::tuple{Vec3{0, 0, 20}, 0, 0.8}, {Vec3{0, 0, -20}, 0, -0.8}, {Vec3{20, 0, 0}, 1, 0.0}}) {
    Bone bone(cone(0.8, 0.4), weightless());
    for (int i = 0; i < 180; ++i) {
      bone.scene.world.apply_torque(bone.bone, torque);
      bone.scene.world.step(kTick);
    }

    if (freedom == 0) CHECK(bone.at(0) == Approx(limit).margin(1e-3));
    else CHECK(std::abs(bone.at(1)) == Approx(0.4).margin(1e-3));
    CHECK(length(bone.scene.world.angular_velocity(bone.bone)) < 1e-2);
  }
}

TEST_CASE("ragdoll: the twist stops at its limits", "[physics]") {
  RagdollDef kind = cone(0.8, 0.4);
  kind.twist.min = -0.3;
  kind.twist.max = 0.6;
  for (const double direction : {1.0, -1.0}) {
    Bone bone(kind, weightless());
    bone.spin({0, -5 * direction, 0});
    double low = 0, high = 0;
    for (int i = 0; i < 120; ++i) {
      bone.scene.world.apply_torque(bone.bone, {0, -0.05 * direction, 0});
      bone.scene.world.step(kTick);
      low = std::min(low, bone.at(2));
      high = std::max(high, bone.at(2));
    }

    CHECK(high < 0.6 + 1e-3);
    CHECK(low > -0.3 - 1e-3);
    CHECK(bone.at(2) == Approx(direction > 0 ? 0.6 : -0.3).margin(1e-3));
  }
}

TEST_CASE("ragdoll: a bone at rest inside its cone hangs as from a ball joint", "[physics]") {
  RagdollDef kind = cone(0.8, 0.4);
  kind.twist.min = kind.twist.max = 0;
  Bone bone(kind);

  bone.scene.run(2);

  CHECK(distance(bone.scene.at(bone.bone), {0, -0.5, 0}) < 1e-9);
  const JointState state = bone.scene.world.state(bone.joint);
  CHECK(state.force.y == Approx(2 * 9.81).epsilon(1e-6));
  CHECK(length(state.torque) < 1e-9);
}

TEST_CASE("ragdoll: a small swing has a pendulum's period", "[physics]") {
  Bone bone(cone(0.8, 0.4));
  bone.spin({0, 0, 0.1});
  const double period = 2 * kPi * std::sqrt(kBoneInertia / (2 * 9.81 * 0.5));
  double first = 0, last_time = 0, last = 0;
  int crossings = 0;

  for (int i = 1; i <= 900; ++i) {
    bone.scene.world.step(kTick);
    const double x = bone.at(0);
    if (last < 0 && x >= 0) {
      last_time = (i - x / (x - last)) * kTick;
      if (crossings++ == 0) first = last_time;
    }
    last = x;
  }

  REQUIRE(crossings > 5);
  CHECK((last_time - first) / (crossings - 1) == Approx(period).epsilon(1e-3));
}

TEST_CASE("ragdoll: motors, springs and locks work along each swing and the twist", "[physics]") {
  RagdollDef kind;
  kind.swing_a.motor.emplace();
  kind.swing_a.motor->target = 0.7;
  kind.swing_b.max = 0;
  kind.twist.spring.emplace();
  kind.twist.spring->frequency = 1;
  kind.twist.spring->damping = 1;
  kind.twist.spring->rest = -0.4;
  Bone bone(kind);

  for (int i = 0; i < 300; ++i) {
    bone.scene.world.step(kTick);
    CHECK(std::abs(bone.at(1)) < 1e-6);
  }

  CHECK(bone.at(0) == Approx(0.7).margin(1e-3));
  CHECK(bone.at(2) == Approx(-0.4).margin(1e-3));
  CHECK(distance(bone.scene.at(bone.bone), Vec3{std::sin(0.7), -std::cos(0.7), 0} * 0.5) < 1e-3);
}

TEST_CASE("ragdoll: friction stops a twist after the angle that its work takes", "[physics]") {
  RagdollDef kind;
  kind.twist.friction = 0.01;
  Bone bone(kind, weightless());
  bone.spin({0, -3, 0});

  bone.scene.run(3);

  CHECK(bone.at(2) == Approx(kBoneTwist * 9 / 2 / 0.01).epsilon(0.01));  // I w^2 / 2 = friction x angle
}
