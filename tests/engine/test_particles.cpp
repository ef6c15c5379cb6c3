#include "engine/particles.h"

#include <algorithm>

#include "engine/extract.h"
#include "test_engine_support.h"

using namespace tumble;

namespace {

struct DrawnGame : PlainGame {
  DrawnGame() {
    particles.set_drawn(true);
    make({{"name", "eye"}, {"camera", Map{}}});
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick_with([] {});
  }
  template <class F>
  void tick_with(F&& scripts) {
    begin_tick();
    scripts();
    step(kTick);
    step_particles(kTick);
    end_tick();
  }
  std::vector<DrawParticle> seen(double alpha = 1) const {
    std::vector<DrawParticle> all;
    for (const DrawParticles& group : extract(*this, alpha, 1).particles)
      all.insert(all.end(), group.particles.begin(), group.particles.end());
    return all;
  }
  std::vector<double> sorted(std::size_t axis, double alpha = 1) const {
    std::vector<double> values;
    for (const DrawParticle& particle : seen(alpha)) values.push_back(particle.position[axis]);
    std::sort(values.begin(), values.end());
    return values;
  }
};

// A jet without chance; tests change what they are about.
Map jet(const Map& changes) {
  Value all(Map{{"rate", 60}, {"life", 10}, {"speed", 1}, {"spread_degrees", 0}, {"variation", 0}});
  for (const auto& [key, value] : changes) all[key] = value;
  return *all.get<Map>();
}

}  // namespace

TEST_CASE("particles: as many begin as rate times time says, evenly spaced in time", "[engine][particles]") {
  DrawnGame game;
  game.make({{"particles", jet({{"rate", 90}, {"speed", 2}})}});

  game.run(121);

  const std::vector<double> heights = game.sorted(1);
  CHECK(heights.size() == 181);  // 121 / 60 s of 90 a second, the last half one waits
  for (std::size_t i = 1; i < heights.size(); ++i) CHECK(heights[i] - heights[i - 1] == Approx(2.0 / 90).epsilon(1e-4));  // floats
}

TEST_CASE("particles: one falls as the formula of a throw says, at every time between two ticks", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"particles", jet({{"rate", 0}, {"speed", 6}, {"gravity_factor", 0.5}})}});
  game.burst_particles(node, 1);
  game.run(40);

  for (const double alpha : {0.0, 0.25, 0.5, 1.0}) {
    const double t = (39 + alpha) / 60;
    const auto seen = game.seen(alpha);
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].position[1] == Approx(6 * t - 0.5 * 9.81 * t * t / 2).epsilon(1e-5));  // a float
  }
}

TEST_CASE("particles: gravity is the world's", "[engine][particles]") {
  DrawnGame game;
  WorldSettings moon;
  moon.gravity = {1.62, 0, 0};
  game.configure_physics(moon);
  const NodeId node = game.make({{"particles", jet({{"speed", 0}, {"rate", 0}, {"gravity_factor", 1}})}});
  game.burst_particles(node, 1);
  game.run(60);

  CHECK(game.seen().at(0).position[0] == Approx(0.81).epsilon(1e-5));
}

TEST_CASE("particles: with damping the place is that of small steps", "[engine][particles]") {
  Particle particle;
  particle.position = {1, 2, 3};
  particle.velocity = {4, 5, -6};
  particle.pull = {0, -9.81, 1};
  particle.damping = 1.7;

  Vec3 x = particle.position, v = particle.velocity;
  constexpr int steps = 100000;
  constexpr double h = 1.5 / steps;
  for (int i = 0; i < steps; ++i) {  // midpoint rule: its error is of order h squared
    const Vec3 middle = v + (particle.pull - v * particle.damping) * (h / 2);
    x += middle * h;
    v += (particle.pull - middle * particle.damping) * h;
  }

  CHECK(distance(place_of(particle, 1.5), x) < 1e-8);
  // Towards no damping the two forms of the formula meet.
  particle.damping = 1e-6;
  const Vec3 damped = place_of(particle, 1.5);
  particle.damping = 0;
  CHECK(distance(damped, place_of(particle, 1.5)) < 1e-4);
}

TEST_CASE("particles: a cone is filled evenly and not left", "[engine][particles]") {
  DrawnGame game;
  const double spread = radians(60);
  const NodeId node = game.make({{"rotation_degrees", Vec3{0, 0, -90}}, {"particles", jet({{"rate", 0}, {"spread_degrees", 60}})}});
  game.burst_particles(node, 8000);
  game.run(60);  // speed 1 for 1 s: each is 1 m from the node, and up is now +x

  double sum = 0;
  for (const DrawParticle& p : game.seen()) {
    const Vec3 at{p.position[0], p.position[1], p.position[2]};
    REQUIRE(length(at) == Approx(1).epsilon(1e-5));
    REQUIRE(at.x > std::cos(spread) - 1e-5);
    sum += at.x;
  }
  // The mean height of a cap of the unit sphere; 8000 values of deviation 0.14 lie within 0.0016 of it, three times taken.
  CHECK(sum / 8000 == Approx((1 + std::cos(spread)) / 2).margin(0.005));
}

TEST_CASE("particles: the box in which they begin is turned and scaled with the node", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"position", Vec3{10, 0, 0}}, {"rotation_degrees", Vec3{0, 90, 0}}, {"scale", Vec3{2, 2, 2}},
                                 {"particles", jet({{"rate", 0}, {"speed", 0}, {"area", Vec3{3, 0, 1}}})}});
  game.burst_particles(node, 2000);
  game.run(1);

  const std::vector<double> x = game.sorted(0), y = game.sorted(1), z = game.sorted(2);
  CHECK((x.front() >= 9 && x.front() < 9.02 && x.back() <= 11 && x.back() > 10.98));
  CHECK((y.front() == Approx(0).margin(1e-6) && y.back() == Approx(0).margin(1e-6)));
  CHECK((z.front() >= -3 && z.front() < -2.95 && z.back() <= 3 && z.back() > 2.95));
}

TEST_CASE("particles: they stay behind a node that moves, at even distances", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"particles", jet({{"rate", 240}, {"speed", 0}})}});
  for (int i = 1; i <= 30; ++i)
    game.tick_with([&] { game.set_position(node, {i * 0.2, 0, 0}); });  // 12 m/s

  const std::vector<double> x = game.sorted(0);
  REQUIRE(x.size() == 120);
  for (std::size_t i = 0; i < x.size(); ++i) CHECK(x[i] == Approx(0.05 * static_cast<double>(i + 1)).margin(1e-5));
  CHECK(game.sorted(0, 0.5).size() == 118);  // half a tick earlier two were not there
}

TEST_CASE("particles: a jump leaves nothing on its way", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"particles", jet({{"rate", 600}, {"speed", 0}})}});
  game.run(2);
  game.tick_with([&] { game.teleport(node, {100, 0, 0}, {}); });

  for (const double x : game.sorted(0)) CHECK((x == 0 || x == 100));
}

TEST_CASE("particles: size and colour go from start to end over the life", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"particles", jet({{"rate", 0}, {"life", 2}, {"size", 0.2}, {"size_end", 1}, {"color", "#ff0000"}, {"glow", 3}})}});
  game.burst_particles(node, 1);
  game.run(30);
  CHECK(game.seen().at(0).size == Approx(0.4));
  CHECK(game.seen().at(0).color == Color{1, 0, 0, 0.75});  // no color_end: it fades
  CHECK(game.seen().at(0).glow == 3);

  game.set(node, "particles.color_end", "#0000ff");
  game.burst_particles(node, 1);
  game.run(60);
  const Color color = game.seen().at(1).color;
  CHECK((color.r == Approx(0.5) && color.g == 0 && color.b == Approx(0.5) && color.a == 1));
}

TEST_CASE("particles: those of a node that goes live to their end, and nothing is left of them", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"particles", jet({{"life", 0.495}})}});  // 29.7 ticks
  game.run(60);
  CHECK(game.seen().size() == 30);
  game.destroy(node);
  game.run(15);
  CHECK(game.seen().size() == 15);
  game.run(16);
  CHECK(game.seen().empty());
  CHECK(game.particles.size() == 0);
}

TEST_CASE("particles: none begin while the emitter is hidden, disabled or not playing; a burst asks only for the first two", "[engine][particles]") {
  DrawnGame game;
  const NodeId parent = game.make({{"name", "parent"}});
  const NodeId node = game.make({{"particles", jet({})}}, parent);
  game.set(parent, "visible", false);
  game.burst_particles(node, 5);
  game.run(10);
  game.set(parent, "visible", true);
  game.set_enabled(parent, false);
  game.burst_particles(node, 5);
  game.run(10);
  game.set_enabled(parent, true);
  game.set(node, "particles.playing", false);
  game.run(10);
  CHECK(game.seen().empty());
  game.burst_particles(node, 5);
  CHECK(game.particles.size() == 5);
}

TEST_CASE("particles: a game is the same with and without them", "[engine][particles]") {
  const auto hash = [](bool drawn) {
    PlainGame game;
    game.particles.set_drawn(drawn);
    const NodeId node = game.make({{"particles", Map{{"rate", 500}}}, {"body", Map{}}, {"mesh", "box"}});
    for (int i = 0; i < 30; ++i) {
      game.begin_tick();
      game.burst_particles(node, 3);
      game.step(PlainGame::kTick);
      game.step_particles(PlainGame::kTick);
    }
    CHECK((game.particles.size() > 0) == drawn);
    return game.hash();
  };
  CHECK(hash(true) == hash(false));
}

TEST_CASE("particles: beyond the limit new ones wait, and the author is told", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.make({{"name", "fire"}, {"particles", jet({{"rate", 0}, {"life", 0.5}})}});
  game.burst_particles(node, 20000);
  CHECK(game.lines.empty());
  game.burst_particles(node, 1);
  CHECK(game.particles.size() == 20000);
  REQUIRE(game.lines.size() == 1);
  CHECK(game.lines[0] == "particles: 20000 are alive, which is the most that a game may have; 'fire' and others wait until some end. "
                         "Give a lower rate or a shorter life");
  game.run(32);
  game.burst_particles(node, 1);
  CHECK(game.particles.size() == 1);
}

TEST_CASE("particles: a restart begins without any, and emitters begin anew", "[engine][particles]") {
  DrawnGame game;
  const NodeId node = game.declare({{"particles", jet({})}});
  game.run(10);
  game.destroy(node);
  game.run(10);
  game.restart_scene();
  CHECK(game.seen().empty());
  game.run(10);
  CHECK(game.seen().size() == 10);
}
