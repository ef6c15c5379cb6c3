#include "joint_bench.h"

using namespace tumble;

namespace {

JointRows rows_at(Quat a, Quat b, const UniversalDef& def = {}) {
  JointRows out;
  rows(def, JointFrame{{{}, a}, {{}, b}, {}, {}}, out);
  return out;
}

Quat turned_by(Vec3 spin, double h, Quat q) { return axis_angle(spin, length(spin) * h) * q; }

double rate(const JointRow& row, Vec3 spin_a, Vec3 spin_b) { return dot(row.angular_a, spin_a) + dot(row.angular_b, spin_b); }

}  // namespace

TEST_CASE("universal: the angles of a turn about the axis and then one about axis_b are read back", "[physics]") {
  const Quat b = axis_angle({1, 2, 3}, 0.8);
  for (const double alpha : {-3.0, -1.6, -0.4, 0.0, 0.3, 1.5, 3.1})
    for (const double beta : {-3.0, -1.5, -0.2, 0.0, 0.9, 1.6, 3.1}) {
      const JointRows rows = rows_at(b * axis_angle({0, 1, 0}, beta) * axis_angle({1, 0, 0}, alpha), b);

      CHECK(rows.free[0].position == Approx(alpha).margin(1e-12));
      CHECK(rows.free[1].position == Approx(beta).margin(1e-12));
      CHECK(std::abs(rows.held[3].error) < 1e-12);
    }
}

TEST_CASE("universal: a row's velocity is the rate of its angle, and of the arms' lean", "[physics]") {
  constexpr double h = 1e-5;
  const Quat b = axis_angle({-1, 2, 0.5}, 1.1), a = b * axis_angle({0, 1, 0}, -0.7) * axis_angle({1, 0, 0}, 1.3);
  const Vec3 arm_a = a * Vec3{1, 0, 0}, arm_b = b * Vec3{0, 1, 0}, spin_b{0.3, -1.2, 0.8};
  // Spins that the joint allows, and one that it does not.
  for (const double leaning : {0.0, 0.5}) {
    const Vec3 spin_a = spin_b + arm_a * 1.7 - arm_b * 0.6 + cross(arm_a, arm_b) * leaning;
    const JointRows now = rows_at(a, b);
    const JointRows later = rows_at(turned_by(spin_a, h, a), turned_by(spin_b, h, b));
    const JointRows before = rows_at(turned_by(spin_a, -h, a), turned_by(spin_b, -h, b));

    for (int i = 0; i < 2; ++i) {
      const auto at = static_cast<std::size_t>(i);
      CHECK(rate(now.free[at].row, spin_a, spin_b) == Approx((later.free[at].position - before.free[at].position) / (2 * h)).epsilon(1e-8));
    }
    CHECK(rate(now.held[3], spin_a, spin_b) == Approx((later.held[3].error - before.held[3].error) / (2 * h)).margin(1e-8));
  }
}

TEST_CASE("universal: a bent shaft turns as Hooke's joint says", "[physics]") {
  constexpr double bend = 0.6;
  Scene scene(weightless());
  const Vec3 along = axis_angle({1, 0, 0}, bend) * Vec3{0, 0, 1};
  BodyDef turned = rod();
  turned.type = BodyType::kinematic;
  const BodyId in = scene.add(turned, {}), out = scene.add(rod(), {0, 0, -1});
  JointDef bearing = hinge(out, {}, {0, 0, 1}), cross;
  scene.world.add(bearing, 0);
  cross.a = in;
  cross.b = out;
  cross.axis = {1, 0, 0};
  UniversalDef kind;
  kind.axis_b = Vec3{0, 1, 0};
  cross.kind = kind;
  scene.world.add(cross, 0);

  double worst = 0;
  for (int i = 1; i <= 400; ++i) {
    scene.world.move(in, {{}, axis_angle(along, 2 * i * kTick)});
    scene.world.step(kTick);
    if (i < 5) continue;
    // From where the driver's arm lies in the plane of both shafts; it began at right angles to it.
    const double theta = kPi / 2 + 2 * i * kTick, ratio = std::cos(bend) / (1 - std::pow(std::sin(bend) * std::cos(theta), 2));
    worst = std::max(worst, std::abs(scene.world.angular_velocity(out).z / (2 * ratio) - 1));
  }

  INFO("worst " << worst);
  CHECK(worst < 1e-3);
}

TEST_CASE("universal: limits hold each turn by itself", "[physics]") {
  Scene scene(weightless());
  const BodyId body = scene.add(rod(), {0.5, 0, 0});
  JointDef def;
  def.a = body;
  def.anchor = {-0.5, 0, 0};
  def.axis = {0, 0, 1};
  UniversalDef kind;
  kind.axis_b = Vec3{0, 1, 0};
  kind.turn_a.min = -0.3;
  kind.turn_a.max = 0.5;
  kind.turn_b.min = kind.turn_b.max = 0;
  def.kind = kind;
  const JointId joint = scene.world.add(def, 0);

  for (int i = 0; i < 180; ++i) {
    scene.world.apply_torque(body, {1, 2, 3});
    scene.world.step(kTick);
    const auto freedoms = scene.world.state(joint).freedoms;
    CHECK(freedoms[0].position < 0.5 + 1e-3);
    CHECK(std::abs(freedoms[1].position) < 1e-6);
  }

  CHECK(scene.world.state(joint).freedoms[0].position == Approx(0.5).margin(1e-3));
  CHECK(scene.at(body).y == Approx(0.5 * std::sin(0.5)).margin(1e-3));  // about z, which is turn_a's
}

TEST_CASE("universal: whole turns of both are counted", "[physics]") {
  Scene scene(weightless());
  const BodyId body = scene.add(rod(), {});
  JointDef def;
  def.a = body;
  def.axis = {1, 0, 0};
  def.kind = UniversalDef{};
  const JointId joint = scene.world.add(def, 0);
  scene.world.set_angular_velocity(body, {5, 0, 0});

  scene.run(3);

  CHECK(scene.world.state(joint).freedoms[0].position == Approx(15).epsilon(1e-6));
  CHECK(scene.world.state(joint).freedoms[0].speed == Approx(5).epsilon(1e-6));
}

TEST_CASE("universal: axis_b may not lie along the axis", "[physics]") {
  Scene scene;
  JointDef def;
  def.a = scene.add(rod(), {});
  def.axis = {0, 2, 0};
  UniversalDef kind;
  kind.axis_b = Vec3{0, -1, 0};
  def.kind = kind;

  CHECK_THROWS_WITH(scene.world.add(def, 0),
                    "joint.universal: axis_b must not be parallel to axis (got 0, -1, 0 and 0, 2, 0); give a direction across it, "
                    "or leave it out");
}
