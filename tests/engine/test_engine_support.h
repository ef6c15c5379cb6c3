// An engine with the verbs that its tests use.
#pragma once

#include <catch2/catch.hpp>

#include "engine/engine.h"

namespace tumble {

struct PlainGame : Engine {
  explicit PlainGame(const GameSettings& settings = {}, bool with_world = true) : Engine(settings, with_world) {
    log = [this](const LogLine& line) { lines.push_back(line.text); };
  }

  static NodeDef read(const Map& keys) {
    NodeDef def;
    assign(def, keys, "scene.add");
    return def;
  }
  NodeId make(const Map& keys, NodeId parent = {}, Origin origin = Origin::added) { return add(read(keys), parent, origin, "scene.add"); }
  NodeId declare(const Map& keys, NodeId parent = {}) { return make(keys, parent, Origin::declared); }
  JointRef tie(const std::string& type, NodeId a, NodeId b, const Map& options = {}, Origin origin = Origin::added) {
    return add_joint(type, "", a, b, options, origin, "joint." + type);
  }
  void set(NodeId node, const std::string& path, const Value& value) { set_field(node, path, value, "node"); }

  // Whole ticks without scripts.
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      begin_tick();
      step(kTick);
      take_events();
      end_tick();
    }
  }
  std::vector<NodeId> end_tick() {
    remove_bodies_of_dying();
    return finish_removals();
  }
  // One tick in which `scripts` runs before the step.
  template <class F>
  void tick_with(F&& scripts) {
    begin_tick();
    scripts();
    step(kTick);
    take_events();
    end_tick();
  }

  Vec3 place(NodeId node) const { return scene.world(node).position; }
  Vec3 velocity(NodeId node) { return world()->velocity(body(node)->id); }

  static constexpr double kTick = 1.0 / 60;
  std::vector<std::string> lines;  // of the log
};

}  // namespace tumble
