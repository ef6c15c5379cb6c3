// Locked axes: what is locked does not move at all, and what is not locked moves as if nothing were.
#include <algorithm>

#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kStill = 1e-6;   // m or rad
constexpr double kFree = 1e-6;    // of the way: A01's goal

double turned(Quat q, int axis) { return 2 * std::abs(axis == 0 ? q.x : axis == 1 ? q.y : q.z); }  // rad, small

double fallen(double seconds) { return kGravity * seconds * seconds / 2; }

// Boxes that fall askew onto each other and may turn about y only.
Outcome pile(Trial& trial) {
  Build build(trial, 0.5);
  build.add_floor();
  Chance chance(15);
  const int count = as_many(trial, 30, 20, 8);
  for (int i = 0; i < count; ++i) {
    BodyDef def = dynamic(box({1, 0.6, 0.8}), 1);
    def.lock_rotation = "xz";
    build.add(def, {{chance.between(-0.8, 0.8), 0.5 + 0.8 * i, chance.between(-0.8, 0.8)}, {}});
  }
  double tilt = 0;
  build.run(lasting(trial, 10, 3, 1), [&](double) {
    for (const Block& block : build.blocks()) {
      const Quat q = build.scene().pose(block.body).rotation;
      tilt = std::max({tilt, turned(q, 0), turned(q, 2)});
    }
    return true;
  });
  build.demand(tilt, kStill);
  return build.judge();
}

// Twenty boxes in a flat pyramid that may not leave its plane: it stands as B02's, and no box leaves it.
Outcome pyramid(Trial& trial) {
  Build build(trial, 0.6);
  build.add_floor();
  int left = 20;
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 6 - row && left > 0; ++i, --left) {
      BodyDef def = dynamic(box({1, 1, 1}), 1);
      def.lock_position = "z";
      build.add(def, {{i + 0.5 * row - 2.5, row + 0.5, 0}, {}});
    }
  double out = 0, most = 0;
  build.run(lasting(trial, 10, 3, 1), [&](double) {
    for (const Block& block : build.blocks()) out = std::max(out, std::abs(build.scene().pose(block.body).position.z));
    most = std::max(most, build.furthest());
    return true;
  });
  build.demand(out, kStill);
  build.demand(most, 0.1);
  return build.judge();
}

// Hangs in the air with a push and a twist on it, while its neighbour without locks falls as it should.
Outcome all_locked(Trial& trial) {
  Build build(trial, 0.5);
  BodyDef def = dynamic(box({1, 1, 1}), 1);
  const BodyIndex free = build.add(def, {{3, 100, 0}, {}});
  def.lock_position = def.lock_rotation = "xyz";
  const Pose start{{0, 100, 0}, {}};
  const BodyIndex body = build.add(def, start);
  constexpr double kSeconds = 2;
  run(build.scene(), kSeconds, kFrame, [&](double) {
    build.scene().apply_force(body, {10, 5, -20});
    build.scene().apply_torque(body, {1, 2, 3});
    return true;
  });
  const Pose now = build.scene().pose(body);
  build.demand(distance(now.position, start.position), kStill);
  build.demand(std::max({turned(now.rotation, 0), turned(now.rotation, 1), turned(now.rotation, 2)}), kStill);
  const double way = 100 - build.scene().pose(free).position.y;
  build.demand(relative(way, trial.reference(fallen(kSeconds))), kFree);
  return build.judge(false);
}

// Its centre of mass is not in its middle: locked against turning, it falls as a point.
Outcome off_center(Trial& trial) {
  Build build(trial, 0.5);
  BodyDef def = dynamic(box({1, 1, 1}), 1);
  def.center_of_mass = Vec3{0.4, 0.1, -0.2};
  def.lock_rotation = "xyz";
  const BodyIndex body = build.add(def, {{0, 100, 0}, {}});
  constexpr double kSeconds = 2;
  run(build.scene(), kSeconds, kFrame, [&](double) {
    build.scene().apply_torque(body, {5, 5, 5});
    return true;
  });
  const Pose now = build.scene().pose(body);
  build.demand(std::hypot(now.position.x, now.position.z), kStill);
  build.demand(std::max({turned(now.rotation, 0), turned(now.rotation, 1), turned(now.rotation, 2)}), kStill);
  build.demand(relative(100 - now.position.y, trial.reference(fallen(kSeconds))), kFree);
  return build.judge(false);
}

// A rod on a ball joint that is locked into a plane and pushed out of it swings as one that nobody pushed.
Outcome jointed(Trial& trial) {
  const auto swing = [&](bool locked) {
    Simulation& scene = trial.scene();
    BodyDef def = dynamic(box({0.1, 1, 0.1}), 1);
    if (locked) {
      def.lock_position = "z";
      def.lock_rotation = "xy";
    }
    const Quat turn = axis_angle({0, 0, 1}, radians(60));
    const BodyIndex rod = scene.add(def, {turn * Vec3{0, -0.5, 0}, turn});
    scene.add(joint(rod, kWorld, {0, 0.5, 0}, BallDef{}));
    std::vector<Vec3> places;
    run(scene, 1, kFrame, [&](double) {
      if (locked) scene.apply_force(rod, {0, 0, 5});
      places.push_back(scene.pose(rod).position);
      return true;
    });
    return places;
  };
  const std::vector<Vec3> locked = swing(true), free = swing(false);
  Outcome outcome;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const Vec3 right = trial.reference(free[i]);
    outcome.error = std::max({outcome.error, std::abs(locked[i].z) / kStill, std::hypot(locked[i].x - right.x, locked[i].y - right.y) / 1e-3});
  }
  return outcome;
}

// A thrown ball whose x is locked half-way: it falls straight down from there.
Outcome toggled(Trial& trial) {
  Build build(trial, 0.5);
  BodyDef def = dynamic(ball(0.5), 1);
  def.velocity = {3, 0, 0};
  const BodyIndex body = build.add(def, {{0, 100, 0}, {}});
  constexpr double kHalf = 0.5;
  run(build.scene(), kHalf);
  const double x = build.scene().pose(body).position.x;
  def.lock_position = "x";
  build.scene().configure(body, def);
  run(build.scene(), kHalf);
  const Vec3 now = build.scene().pose(body).position;
  build.demand(std::abs(now.x - x), kStill);
  build.demand(relative(100 - now.y, trial.reference(fallen(2 * kHalf))), kFree);
  return build.judge(false);
}

}  // namespace

Case b15_locked_axes() {
  return {"B15", "Locked axes", "a pile that may turn about y only, a flat pyramid locked into its plane, boxes locked in all or in part, a locked rod on a joint, a lock at run time",
          "locked axes do not change; the others as without a lock", "change of a locked axis over 1e-6, error of the free ones over A01's goal (joint: 1 mm, pyramid: 0.1 m)",
          {{"rotation xz, pile", 1, pile},
           {"position z, pyramid", 1, pyramid},
           {"all", 1, all_locked},
           {"centre of mass aside", 1, off_center},
           {"with a joint", 1, jointed},
           {"at run time", 1, toggled}}};
}

}  // namespace tumble::accuracy
