// Options that a joint takes and was not given read as nil; others are errors with the nearest name.
#include <catch2/catch.hpp>

#include "engine/joint_options.h"
#include "physics/joint.h"
#include "support/test_game.h"

using namespace tumble;

TEST_CASE("joints: every described option of every kind can be read, and nothing else", "[script]") {
  for (const std::string& kind : joint_kind_names()) {
    std::string reads;
    for (const std::string& name : joint_option_names(kind)) reads += "  local _ = j." + name + "\n";
    const std::string make = "local a = scene.add { name = 'a', mesh = 'box', body = {} }\nlocal j = joint." + kind + " { a = a }\n";

    TestGame good(Files{{"main.lua", make + "function start()\n" + reads + "end\n"}});
    INFO(kind);
    CHECK(good.last_error() == "");

    TestGame wrong(Files{{"main.lua", make + "function start() local _ = j.break_forse end\n"}});
    CHECK(wrong.last_error().find("has no 'break_forse'") != std::string::npos);
  }
}

TEST_CASE("joints: an option reads as it was last written", "[script]") {
  TestGame game(Files{{"main.lua", R"(
    local door = scene.add { name = "door", mesh = "box", body = {} }
    local hinge = joint.hinge { a = door, world_axis = vec3.up, min = -1, motor = { target_degrees = 40, torque = 60 } }
    function start()
      hinge.motor.target, hinge.min_degrees, hinge.max = 0.5, -90, 2
      game.report.target, game.report.min, game.report.max = hinge.motor.target, hinge.min_degrees, hinge.max
      hinge.max = nil
      game.report.free = hinge.max == nil and 1 or 0
    end)"}});

  game.tick(2);

  CHECK(game.last_error() == "");
  CHECK(game.number("target") == 0.5);
  CHECK(game.number("min") == -90);
  CHECK(game.number("max") == 2);
  CHECK(game.number("free") == 1);
}

TEST_CASE("joints: freedoms with tables of their own tell where they are and can be written", "[script]") {
  TestGame game(Files{{"main.lua", R"(
    local ring = scene.add { name = "ring", mesh = "box", body = { gravity_factor = 0 } }
    local rod = joint.cylindrical { a = ring, axis = vec3.up }
    function start() ring.body.velocity, ring.body.angular_velocity = vec3(0, 1, 0), vec3(0, 2, 0) end
    function update()
      if time.tick == 61 then
        game.report.slide, game.report.slide_speed = rod.slide.position, rod.slide.speed
        game.report.angle, game.report.degrees = rod.turn.angle, rod.turn.angle_degrees
        rod.slide.max = 1.2
        rod.turn = { motor = { speed = -1 } }
      elseif time.tick == 121 then
        game.report.stopped, game.report.turned = rod.slide.position, rod.turn.speed
        game.report.limit, game.report.motor = rod.slide.max, rod.turn.motor.speed
        game.report.none = rod.slide.min == nil and rod.slide.motor == nil and 1 or 0
      end
    end)"}});

  game.tick(125);

  CHECK(game.last_error() == "");
  CHECK(game.number("slide") == Approx(1).margin(0.02));
  CHECK(game.number("slide_speed") == Approx(1).epsilon(1e-6));
  CHECK(game.number("angle") == Approx(2).margin(0.04));
  CHECK(game.number("degrees") == Approx(degrees(game.number("angle"))).epsilon(1e-9));
  CHECK(game.number("stopped") == Approx(1.2).margin(1e-3));
  CHECK(game.number("turned") == Approx(-1).epsilon(1e-6));
  CHECK(game.number("limit") == 1.2);
  CHECK(game.number("motor") == -1);
  CHECK(game.number("none") == 1);
}
