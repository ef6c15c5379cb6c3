#include "joint_bench.h"

using namespace tumble;

namespace {

// A rod of 2 kg along x, which slides along x and turns about it.
struct Ring {
  explicit Ring(const CylindricalDef& kind) : scene(weightless()) {
    body = scene.add(rod(), {});
    JointDef def;
    def.a = body;
    def.axis = {1, 0, 0};
    def.kind = kind;
    joint = scene.world.add(def, 0);
  }
  FreedomState slide() const { return scene.world.state(joint).freedoms.at(0); }
  FreedomState turn() const { return scene.world.state(joint).freedoms.at(1); }
  Scene scene;
  BodyId body;
  JointId joint;
};

}  // namespace

TEST_CASE("cylindrical: the slide swings on its spring while the turn goes on freely", "[physics]") {
  CylindricalDef kind;
  kind.slide.spring.emplace();
  kind.slide.spring->frequency = 2;
  Ring ring(kind);
  ring.scene.world.set_velocity(ring.body, {1, 0, 0});
  ring.scene.world.set_angular_velocity(ring.body, {3, 0, 0});

  const double w = 2 * kPi * 2;
  for (int i = 1; i <= 240; ++i) {
    ring.scene.world.step(kTick);
    const double t = i * kTick;
    CHECK(ring.slide().position == Approx(std::sin(w * t) / w).margin(1e-3 / w));
    CHECK(ring.turn().position == Approx(3 * t).epsilon(1e-9));
  }
  CHECK(ring.turn().speed == Approx(3).epsilon(1e-9));
  CHECK(ring.slide().name == "slide");
  CHECK(ring.turn().name == "turn");
}

TEST_CASE("cylindrical: nothing slips sideways or tilts", "[physics]") {
  Ring ring({});

  for (int i = 0; i < 120; ++i) {
    ring.scene.world.apply_force(ring.body, {1, 20, -5});
    ring.scene.world.apply_torque(ring.body, {0.1, 3, 2});
    ring.scene.world.step(kTick);
  }

  CHECK(ring.scene.at(ring.body).x == Approx(0.5 * 0.5 * 4).epsilon(0.01));  // F / m t^2 / 2
  CHECK(std::hypot(ring.scene.at(ring.body).y, ring.scene.at(ring.body).z) < 1e-9);
  CHECK(length(ring.scene.world.pose(ring.body).rotation * Vec3{1, 0, 0} - Vec3{1, 0, 0}) < 1e-9);
}

TEST_CASE("cylindrical: each freedom has limits of its own", "[physics]") {
  CylindricalDef kind;
  kind.slide.min = -0.2;
  kind.slide.max = 0.3;
  kind.turn.min = kind.turn.max = 0;
  Ring ring(kind);

  for (int i = 0; i < 120; ++i) {
    ring.scene.world.apply_force(ring.body, {4, 0, 0});
    ring.scene.world.apply_torque(ring.body, {1, 0, 0});
    ring.scene.world.step(kTick);
    CHECK(ring.slide().position < 0.3 + 1e-3);
    CHECK(std::abs(ring.turn().position) < 1e-9);
  }

  CHECK(ring.slide().position == Approx(0.3).margin(1e-3));
}
