// What is built of loose blocks, and a watch over it: the stability cases of this folder say what they build and what
// they demand of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "accuracy/geometry.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

// Seconds of a run by the trial's effort; the row says so where they are fewer than in the full run.
double lasting(Trial& trial, double full, double quick, double test);
// Of what takes over a minute at full length: that only in a soak.
double soaking(Trial& trial, double soak, double full, double quick, double test);
// Likewise of a number of bodies, levels or tries.
int as_many(Trial& trial, int full, int quick, int test);

struct Block {
  BodyIndex body = 0;
  Pose start;
};

class Build {
 public:
  // `friction` is that of every pair, so each body gets its root: a pair has the product.
  Build(Trial& trial, double friction, const SceneSettings& settings = {});

  Simulation& scene() { return scene_; }
  const std::vector<Block>& blocks() const { return blocks_; }      // those that move, by age
  const Block& block(int index) const { return blocks_.at(static_cast<std::size_t>(index)); }
  const Block& last() const { return blocks_.back(); }
  BodyIndex add(BodyDef def, const Pose& pose);
  BodyIndex add_floor(double side = 40);

  // Steps it, and `each` is called after each step with the seconds since the start of this run. Ends early where it
  // says false, or where a block is not finite or is a metre below the floor, which fails it.
  void run(double seconds, const std::function<bool(double)>& each = [](double) { return true; });

  // What a stable engine owes: the measured over the allowed, whose worst is the error.
  void demand(double measured, double allowed);
  void fail(const std::string& what);                               // the first failure is kept
  bool failed() const { return !outcome_.failed.empty(); }
  // How far a block is from where it should be, along y and across, m. The right place goes through the reference.
  struct Way {
    double up = 0, across = 0;
    double far() const { return std::hypot(up, across); }
  };
  Way way(BodyIndex body, Vec3 right_place) const;
  Way moved(const Block& block) const { return way(block.body, block.start.position); }
  double furthest() const;                                          // of all blocks, m
  double fastest() const;                                           // of all blocks, m/s
  double energy() const;                                            // J, above y = 0
  std::vector<Overlap> overlaps() const { return accuracy::overlaps(scene_, placed_); }
  // Adds what every case of stability demands: energy as at the start after the first step within half a percent, and
  // never more than a percent above it.
  Outcome judge(bool of_energy = true);

 private:
  bool look(double seconds);

  Trial& trial_;
  Simulation& scene_;
  double friction_;          // of each body
  std::vector<Block> blocks_;
  std::vector<Placed> placed_;
  Outcome outcome_;
  double start_energy_ = 0, first_energy_ = 0, most_energy_ = 0;
  bool started_ = false;
};

// "Stands", as all cases mean it: for the whole run the last block is across within a quarter of `block`, and from
// `settled` on its height is right within `sink`; it has fallen when it is a whole block lower or two aside.
struct Stand {
  double seconds = 20, settled = 0;
  double block = 1;          // m
  double sink = 0.02;        // m
  double height = 0;         // of the last block, m; where it starts if it is 0
};
void demand_stand(Build& build, const Stand& stand);

}  // namespace tumble::accuracy
