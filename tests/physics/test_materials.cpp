#include <random>

#include "physical.h"

using namespace tumble;

namespace {

// Speed upwards right after a ball hit the floor.
double rebound(Scene& scene, BodyId id) {
  for (int i = 0; i < 120; ++i) {
    scene.world.step(kTick);
    if (scene.world.velocity(id).y > 0) return scene.world.velocity(id).y;
  }
  return 0;
}

double bounce(double floor_restitution, double ball_restitution, std::optional<Combine> rule) {
  Scene scene;
  BodyDef ground = body(box({10, 1, 10}), BodyType::fixed);
  ground.restitution = floor_restitution;
  scene.add(ground, {0, -0.5, 0});
  BodyDef def = body(ball(0.25));
  def.restitution = ball_restitution;
  def.restitution_combine = rule;
  const BodyId id = scene.add(def, {0, 2.25, 0});
  return rebound(scene, id) / std::sqrt(2 * 9.81 * 2);
}

double stop_distance(double mu_floor, double mu_box, std::optional<Combine> rule) {
  Scene scene;
  BodyDef ground = body(box({40, 1, 40}), BodyType::fixed);
  ground.friction = mu_floor;
  scene.add(ground, {0, -0.5, 0});
  BodyDef def = body(box({1, 0.2, 1}));
  def.friction = mu_box;
  def.friction_combine = rule;
  const BodyId id = scene.add(def, {0, 0.1, 0});
  scene.run(0.2);
  const double start = scene.at(id).x;
  scene.world.set_velocity(id, {3, 0, 0});
  scene.run(4);
  return scene.at(id).x - start;
}

}  // namespace

TEST_CASE("materials: restitution is the combined one", "[physics]") {
  // Within 5 %: one substep of gravity and the way left at the hit are not seen by the bounce.
  CHECK(bounce(0, 0.8, {}) == Approx(0.8).epsilon(0.05));          // the world's rule is max
  CHECK(bounce(0.4, 0.8, Combine::min) == Approx(0.4).epsilon(0.05));
  CHECK(bounce(0.4, 0.8, Combine::average) == Approx(0.6).epsilon(0.05));
  CHECK(bounce(0.5, 0.8, Combine::multiply) == Approx(0.4).epsilon(0.05));
  CHECK(bounce(0, 1, {}) == Approx(1).epsilon(0.05));
  CHECK(bounce(0, 0, {}) == Approx(0).margin(0.02));
}

TEST_CASE("materials: a sliding box stops after v^2 / (2 mu g)", "[physics]") {
  const auto expected = [](double mu) { return 9 / (2 * mu * 9.81); };

  // 2 %: a substep of time.
  CHECK(stop_distance(0.5, 0.8, {}) == Approx(expected(0.4)).epsilon(0.02));
  CHECK(stop_distance(0.5, 0.8, Combine::average) == Approx(expected(0.65)).epsilon(0.02));
  CHECK(stop_distance(0.5, 0.8, Combine::max) == Approx(expected(0.8)).epsilon(0.02));
  CHECK(stop_distance(0.5, 0.8, Combine::min) == Approx(expected(0.5)).epsilon(0.02));
}

TEST_CASE("materials: a collider's own friction holds where it touches", "[physics]") {
  Scene scene;
  scene.floor();
  BodyDef def = body(box({1, 0.2, 1}));
  def.friction = 1;
  def.colliders[0].friction = 0;
  const BodyId id = scene.add(def, {0, 0.1, 0});
  scene.run(0.1);
  scene.world.set_velocity(id, {2, 0, 0});

  scene.run(1);

  CHECK(scene.world.velocity(id).x == Approx(2).epsilon(1e-6));
}

TEST_CASE("materials: a change of friction holds from the next step", "[physics]") {
  Scene scene;
  scene.floor();
  BodyDef def = body(box({1, 0.2, 1}));
  def.friction = 0;
  const BodyId id = scene.add(def, {0, 0.1, 0});
  scene.run(0.5);
  scene.world.set_velocity(id, {2, 0, 0});
  scene.run(0.2);
  REQUIRE(scene.world.velocity(id).x == Approx(2).epsilon(1e-6));

  def = scene.world.def(id);
  def.friction = 1;
  scene.world.configure(id, def);
  scene.run(0.2);

  CHECK(scene.world.velocity(id).x == Approx(2 - 0.5 * 9.81 * 0.2).margin(0.05));
}

TEST_CASE("materials: a belt brings what lies on it to its speed", "[physics]") {
  Scene scene;
  BodyDef belt = body(box({40, 1, 4}), BodyType::fixed);
  belt.surface_velocity = {1.5, 0, 0};
  scene.add(belt, {0, -0.5, 0});
  const BodyId id = scene.add(body(box({0.5, 0.5, 0.5})), {-5, 0.25, 0});

  scene.run(3);

  CHECK(scene.world.velocity(id).x == Approx(1.5).epsilon(0.01));
  CHECK(std::abs(scene.world.velocity(id).z) < 0.01);
}

// A solid ball that rolls is braked by c g / (1 + 2/5), since the force at its rim also has to slow its turning.
TEST_CASE("materials: rolling friction brakes a ball by 5/7 of c g, and holds it on slopes up to c", "[physics]") {
  const double c = 0.05, v = 2;
  Scene scene;
  scene.floor();
  BodyDef def = body(ball(0.25));
  def.friction = 1;
  def.rolling_friction = c;
  def.velocity = {v, 0, 0};
  def.angular_velocity = {0, 0, -v / 0.25};
  const BodyId id = scene.add(def, {0, 0.25, 0});
  scene.run(1);
  CHECK(scene.world.velocity(id).x == Approx(v - c * 9.81 / 1.4).epsilon(1e-3));
  scene.run(9);
  CHECK(scene.at(id).x == Approx(v * v / (2 * c * 9.81 / 1.4)).epsilon(2e-3));
  CHECK(length(scene.world.velocity(id)) < 1e-6);

  for (const double part : {0.9, 1.1}) {
    const double slope = std::atan(c * part);
    WorldSettings tilted;
    tilted.gravity = Vec3{std::sin(slope), -std::cos(slope), 0} * 9.81;
    tilted.sleeping = false;
    Scene hill(tilted);
    hill.floor();
    def.velocity = def.angular_velocity = {};
    const BodyId stone = hill.add(def, {0, 0.25, 0});
    hill.run(10);
    // Beyond c it rolls with what is left of gravity along the slope.
    const double expected = part < 1 ? 0 : (std::sin(slope) - c * std::cos(slope)) * 9.81 / 1.4 * 100 / 2;
    CHECK(hill.at(stone).x == Approx(expected).margin(0.02));
  }
}

TEST_CASE("materials: spinning friction stops a ball that spins on the spot, whichever of the two bodies has it", "[physics]") {
  const double c = 0.02, r = 0.25, w = 5;
  for (const bool on_floor : {false, true}) {
    Scene scene;
    BodyDef ground = body(box({10, 1, 10}), BodyType::fixed), def = body(ball(r));
    (on_floor ? ground : def).spinning_friction = c;
    scene.add(ground, {0, -0.5, 0});
    def.angular_velocity = {0, w, 0};
    const BodyId id = scene.add(def, {0, r, 0});
    scene.run(0.5);
    CHECK(scene.world.angular_velocity(id).y == Approx(w - c * 9.81 / (0.4 * r) * 0.5).epsilon(2e-3));
    scene.run(3);
    CHECK(length(scene.world.angular_velocity(id)) < 1e-9);
    CHECK(std::abs(scene.at(id).x) + std::abs(scene.at(id).z) < 1e-6);
  }
}

TEST_CASE("materials: rolling friction slows a cylinder, a wheel of several colliders, and no box", "[physics]") {
  const double c = 0.1, r = 0.3, v = 2;
  const Quat lies = axis_angle({1, 0, 0}, kPi / 2);
  BodyDef cylinder = body(upright(ShapeKind::cylinder, r, 0.4)), wheel = cylinder;
  wheel.colliders = {collider(upright(ShapeKind::cylinder, r, 0.2), {0, 0.1, 0}), collider(upright(ShapeKind::cylinder, r, 0.2), {0, -0.1, 0})};
  for (BodyDef* def : {&cylinder, &wheel}) {
    Scene scene;
    scene.floor();
    def->friction = 1;
    def->rolling_friction = c;
    def->velocity = {v, 0, 0};
    def->angular_velocity = {0, 0, -v / r};
    const BodyId id = scene.add(*def, {0, r, 0}, lies);
    scene.run(1);
    CHECK(scene.world.velocity(id).x == Approx(v - c * 9.81 / 1.5).epsilon(5e-3));
  }
  Scene scene;
  scene.floor();
  BodyDef sled = body(box({1, 0.5, 1}));
  sled.friction = 0;
  sled.rolling_friction = c;
  sled.velocity = {v, 0, 0};
  const BodyId id = scene.add(sled, {0, 0.25, 0});
  scene.run(1);
  CHECK(scene.world.velocity(id).x == Approx(v).epsilon(1e-9));
}

// A ball that rolls without slip on a board is dragged by f and turned by it, so that its rim runs at 7/2 f / m; the board, of
// mass M, moves by what 25 of them and the floor leave of the push (SimBenchmark's "rolling").
TEST_CASE("materials: balls that roll on a pushed board move as they should, however many there are", "[physics]") {
  const double board_mass = 10, push = 150, floor_friction = 0.4, drag = floor_friction * (board_mass + 25) * 9.81;
  const double on_ball = (push - drag) / (3.5 * board_mass + 25), board_rate = (push - drag - 25 * on_ball) / board_mass;
  Scene scene;
  scene.add(body(box({60, 1, 60}), BodyType::fixed), {0, -0.5, 0});
  BodyDef def = body(box({20, 1, 20}));
  def.mass = board_mass;
  def.friction = floor_friction / 0.5;
  const BodyId board = scene.add(def, {0, 0.5, 0});
  def = body(ball(0.5));
  def.friction = 1;
  std::vector<BodyId> balls;
  for (int i = 0; i < 25; ++i) balls.push_back(scene.add(def, {2.0 * (i % 5 - 2), 1.5, 2.0 * (i / 5 - 2)}));
  const Vec3 along = normalized(Vec3{1, 0, 1.7});
  for (int i = 0; i < 60; ++i) {
    scene.world.apply_force(board, along * push);
    scene.world.step(kTick);
  }
  CHECK(dot(scene.world.velocity(board), along) == Approx(board_rate).epsilon(0.003));
  for (const BodyId id : balls) CHECK(dot(scene.world.velocity(id), along) == Approx(on_ball).epsilon(0.003));
}

// Friction that held a twist while an area pressed is nothing's to keep when one corner is left.
TEST_CASE("materials: a box that tumbles over its corners never gains energy", "[physics]") {
  std::mt19937 random(5);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int turn = 0; turn < 40; ++turn) {
    Scene scene;
    scene.floor();
    BodyDef def = body(box({0.5, 0.5, 0.5}));
    def.friction = 1;
    def.can_sleep = false;
    def.velocity = {number(-3, 3), 0, number(-3, 3)};
    def.angular_velocity = {number(-8, 8), number(-15, 15), number(-8, 8)};
    const BodyId id = scene.add(def, {0, 0.5, 0}, axis_angle({number(-1, 1), number(-1, 1), number(-1, 1)}, number(0, 3)));
    const auto energy = [&] { return scene.world.kinetic_energy(id) + 9.81 * scene.at(id).y; };
    const double start = energy();
    double before = start, gained = 0;
    for (int i = 0; i < 180; ++i) {
      scene.world.step(kTick);
      const double now = energy();
      gained += std::max(0.0, now - before);
      before = now;
    }
    INFO("throw " << turn);
    CHECK(gained < 0.02 * start);
  }
}
