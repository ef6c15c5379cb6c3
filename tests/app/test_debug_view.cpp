#include "app/debug_view.h"

#include <algorithm>

#include "engine/test_engine_support.h"
#include "support/test_game.h"

using namespace tumble;

namespace {

constexpr double kWide = 16.0 / 9;

struct Seen : PlainGame {
  DrawList show(DebugView view, double alpha = 1, const std::vector<DebugQuery>& queries = {}, double dropped_seconds = 0) const {
    DrawList list;
    list.origin = {0, 0, 10};   // looks along -z at the origin
    add_debug_view(list, *this, view, queries, alpha, kWide, dropped_seconds);
    return list;
  }
};

Vec3 vec(const std::array<float, 3>& p) { return {p[0], p[1], p[2] + 10}; }

// The ends of the lines of a colour, world.
std::vector<std::pair<Vec3, Vec3>> lines_of(const DrawList& list, const Color& color) {
  std::vector<std::pair<Vec3, Vec3>> lines;
  for (const DrawLine& line : list.lines)
    if (line.color == color) lines.emplace_back(vec(line.from), vec(line.to));
  return lines;
}

bool has_end(const std::vector<std::pair<Vec3, Vec3>>& lines, Vec3 at) {
  return std::any_of(lines.begin(), lines.end(), [&](const auto& line) { return distance(line.first, at) < 1e-5 || distance(line.second, at) < 1e-5; });
}

bool says(const DrawList& list, const std::string& text) {
  return std::any_of(list.ui.begin(), list.ui.end(), [&](const DrawUi& ui) { return ui.is_text && ui.text.text.find(text) != std::string::npos; });
}

const Color kAwake{1, 0.65, 0, 1}, kAsleep{0.62, 0.62, 0.68, 1}, kKinematic{0.4, 0.65, 1, 1}, kStatic{0.35, 0.85, 0.4, 1}, kTrigger{0.9, 0.4, 0.95, 1};
const Color kRange{1, 0.6, 0.15, 1}, kNeedle{1, 1, 1, 1}, kContact{1, 0.25, 0.2, 1}, kRay{1, 1, 0.2, 1}, kVelocity{0.2, 0.95, 1, 1};

}  // namespace

TEST_CASE("debug view: colliders are coloured by their body's state, and counted", "[app][debug]") {
  Seen game;
  const auto add = [&](const Map& body, double x) { return game.make({{"position", Vec3{x, 0, 0}}, {"mesh", "box"}, {"body", body}}); };
  add({{"gravity_factor", 0}}, 0);
  const NodeId sleeper = add({}, 2);
  add({{"type", "kinematic"}}, 4);
  add({{"type", "static"}}, 6);
  add({{"type", "static"}, {"trigger", true}}, 8);
  game.world()->sleep(game.body(sleeper)->id);

  const DrawList list = game.show(DebugView::colliders);

  double x = 0;
  for (const Color& color : {kAwake, kAsleep, kKinematic, kStatic, kTrigger}) {
    const auto lines = lines_of(list, color);
    CHECK(lines.size() == 12);
    CHECK(has_end(lines, {x + 0.5, 0.5, 0.5}));
    x += 2;
  }
  CHECK(list.lines.size() == 5 * 24);   // each a second time, faint and on top
  for (const char* state : {"awake  1", "asleep  1", "kinematic  1", "static  1", "trigger  1", "5 bodies, 0 joints"}) CHECK(says(list, state));
}

TEST_CASE("debug view: lines stand where the picture shows their node", "[app][debug]") {
  Seen game;
  game.make({{"mesh", "box"}, {"body", Map{{"gravity_factor", 0}, {"velocity", Vec3{60, 0, 0}}}}});  // 1 m a tick
  game.run(2);

  CHECK(has_end(lines_of(game.show(DebugView::colliders, 0.25), kAwake), {1.75, 0.5, 0.5}));
}

TEST_CASE("debug view: a hinge shows its limits as an arc and its angle as a needle", "[app][debug]") {
  Seen game;
  const NodeId door = game.make({{"position", Vec3{1, 0, 0}}, {"mesh", "box"}, {"body", Map{{"gravity_factor", 0}}}});
  const double low = -0.5, high = 1.2;
  game.tie("hinge", door, {}, {{"anchor", Vec3{-1, 0, 0}}, {"axis", Vec3{1, 0, 0}}, {"min", low}, {"max", high}});
  const double r = 0.5;   // half the way from the door's centre to the hinge
  const auto at = [&](double angle) { return Vec3{0, r * std::cos(angle), r * std::sin(angle)}; };

  const DrawList list = game.show(DebugView::joints);

  const auto range = lines_of(list, kRange);
  CHECK(has_end(range, at(low)));
  CHECK(has_end(range, at(high)));
  double arc = 0;
  for (const auto& [from, to] : range)
    if (std::abs(length(from) - r) < 1e-5) arc += distance(from, to);
  CHECK(arc == Approx(r * (high - low)).epsilon(0.01));   // chords of 15 degrees are 0.3 % short of it
  CHECK(has_end(lines_of(list, kNeedle), at(0)));

  game.world()->set_angular_velocity(game.body(door)->id, {1, 0, 0});
  game.run(30);
  CHECK(has_end(lines_of(game.show(DebugView::joints), kNeedle), at(0.5)));
}

TEST_CASE("debug view: a slider shows its way between its limits", "[app][debug]") {
  Seen game;
  const NodeId box = game.make({{"mesh", "box"}, {"body", Map{{"gravity_factor", 0}}}});
  game.tie("slider", box, {}, {{"axis", Vec3{0, 1, 0}}, {"min", -1}, {"max", 2}});

  const auto range = lines_of(game.show(DebugView::joints), kRange);

  CHECK(has_end(range, {0, -1, 0}));
  CHECK(has_end(range, {0, 2, 0}));
}

TEST_CASE("debug view: a ragdoll shows its cone, a universal joint the ranges of both arms", "[app][debug]") {
  Seen game;
  const NodeId bone = game.make({{"position", Vec3{1, 0, 0}}, {"mesh", "box"}, {"body", Map{{"gravity_factor", 0}}}});
  game.tie("ragdoll", bone, {}, {{"anchor", Vec3{-1, 0, 0}}, {"axis", Vec3{1, 0, 0}}, {"swing_axis", Vec3{0, 1, 0}},
                                 {"swing_a", Map{{"max", 0.8}}}, {"swing_b", Map{{"max", 0.4}}}});
  const double r = 0.5;   // half the way from the bone's centre to the joint

  const auto cone = lines_of(game.show(DebugView::joints), kRange);

  CHECK(has_end(cone, {r * std::cos(0.8), 0, -r * std::sin(0.8)}));
  CHECK(has_end(cone, {r * std::cos(0.4), r * std::sin(0.4), 0}));

  game.tie("universal", bone, {}, {{"anchor", Vec3{-1, 0, 0}}, {"axis", Vec3{1, 0, 0}}, {"axis_b", Vec3{0, 1, 0}},
                                   {"turn_a", Map{{"min", -0.3}, {"max", 0.6}}}});
  CHECK(has_end(lines_of(game.show(DebugView::joints), kRange), {0, r * std::cos(0.6), -r * std::sin(0.6)}));
}

TEST_CASE("debug view: the forces of a box at rest add up to its weight", "[app][debug]") {
  Seen game;
  game.make({{"position", Vec3{0, -0.5, 0}}, {"mesh", Map{{"size", Vec3{10, 1, 10}}}}, {"body", "static"}});
  game.make({{"position", Vec3{0, 0.5, 0}}, {"mesh", "box"}, {"body", Map{{"mass", 4}, {"can_sleep", false}}}});
  game.run(120);

  double force = 0;
  for (const auto& [from, to] : lines_of(game.show(DebugView::contacts), kContact))
    if (distance(from, to) > 0.0601) force += std::pow(distance(from, to) / 0.1, 2);   // crosses are 0.06 long

  CHECK(force == Approx(4 * 9.81).epsilon(0.02));   // the solver's last digits differ from tick to tick
}

TEST_CASE("debug view: a ray is bright to its hit, which shows the surface's direction", "[app][debug]") {
  Seen game;
  game.make({{"mesh", "box"}, {"body", "static"}});
  DebugQuery ray{{-3, 0, 0}, {3, 0, 0}, 2.5, {}, {{{-0.5, 0, 0}, {-1, 0, 0}}}};

  const DrawList list = game.show(DebugView::rays, 1, {ray});

  REQUIRE(lines_of(list, kRay).size() == 1);
  CHECK(distance(lines_of(list, kRay)[0].second, {-0.5, 0, 0}) < 1e-6);
  CHECK(has_end(lines_of(list, kContact), {-0.8, 0, 0}));
}

TEST_CASE("debug view: velocities are the way of 0.2 s, names stand over their bodies", "[app][debug]") {
  Seen game;
  game.make({{"name", "stone"}, {"mesh", "box"}, {"body", Map{{"gravity_factor", 0}, {"velocity", Vec3{2, 0, 0}}}}});

  CHECK(has_end(lines_of(game.show(DebugView::velocities), kVelocity), {0.4, 0, 0}));
  const DrawList list = game.show(DebugView::names);
  CHECK(list.lines.empty());
  CHECK(says(list, "stone"));
}

TEST_CASE("debug view: nothing at all when it is off, a sentence without bodies", "[app][debug]") {
  Seen game;
  CHECK(says(game.show(DebugView::physics), "no bodies in this game yet"));
  game.make({{"mesh", "box"}, {"body", Map{}}});
  CHECK(game.show(DebugView::none).ui.empty());
  CHECK(game.show(DebugView::none).lines.empty());
}

TEST_CASE("debug view: scripts' questions are noted only while it shows them, and nobody's hash knows", "[app][debug]") {
  const auto asked = [](const std::string& view, std::size_t& queries) {
    TestGame game({{"main.lua", "physics.debug_view = '" + view + R"lua('
      scene.add { mesh = "box", position = vec3(5, 0, 0), body = { gravity_factor = 0 } }
      function update()
        physics.raycast(vec3.zero, vec3.right, 20)
        physics.raycast_to(vec3.zero, vec3(0, 9, 0))
        physics.raycast_all(vec3.zero, vec3.right, 20)
        physics.raycast_any(vec3.zero, vec3.right, 20)
        physics.cast({ shape = "sphere", radius = 0.2 }, vec3.zero, vec3.right, 20)
        physics.overlap("box", vec3(5, 0, 0))
      end)lua"}});
    game.tick(1);
    CHECK(game.last_error() == "");
    queries = game.script->tick_drawing().queries.size();
    if (queries > 0) {
      const auto& list = game.script->tick_drawing().queries;
      CHECK(list[0].stop == Approx(4.5));
      CHECK(list[1].hits.empty());
      CHECK(list[4].stop == Approx(4.3));
      CHECK(list[4].shape->radius == 0.2);
    }
    return game.script->hash();
  };
  std::size_t on = 0, all = 0, off = 0;
  const std::uint64_t hash = asked("rays", on);
  CHECK(hash == asked("physics", all));
  CHECK(hash == asked("colliders", off));
  CHECK(on == 6);
  CHECK(all == 6);
  CHECK(off == 0);
}

TEST_CASE("debug view: time that was dropped is told, and only then", "[app][debug]") {
  const Seen game;

  CHECK(says(game.show(DebugView::colliders, 1, {}, 2.9), "2.9 s dropped"));
  CHECK_FALSE(says(game.show(DebugView::colliders), "dropped"));
}
