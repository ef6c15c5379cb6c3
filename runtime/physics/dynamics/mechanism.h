// Joints that share bodies, solved together: the rows that hold are one system of equations, solved directly, so that a
// chain of any length and any ratio of masses holds in one go; what drives and limits acts along freedoms that already
// know the whole mechanism.
//
// Two projections a substep, as in RATTLE: before the drift, impulses along the old rows that bring the joints together
// after it (SHAKE; J.-P. Ryckaert and others, J. Comput. Phys. 23, 1977), after it, impulses along the new ones that
// leave no velocity across them. Both are symmetric in time, so that a pendulum keeps its energy.
#pragma once

#include "physics/dynamics/drive.h"
#include "physics/dynamics/energy.h"
#include "physics/dynamics/factor.h"

namespace tumble::dynamics {

class Mechanism {
 public:
  explicit Mechanism(std::vector<Link*> links);
  const std::vector<Link*>& links() const { return links_; }
  const std::vector<Mover*>& bodies() const { return bodies_; }  // that can be pushed
  bool touched = false;  // a contact acts on one of its bodies

  // How much energy it took to close gaps, of that of the motion, over h^2: what whips round wants smaller substeps. Of
  // the last steps.
  double whip() const { return whip_; }
  // At the start of a step: descriptions may have changed, bodies may have jumped.
  void begin_step(double h);
  // Before the first kick of a substep.
  void begin();
  // Takes the velocities across the joints away, and nothing else.
  void solve_held();
  // Before the drift: as often as contacts need it. The first time in a substep, springs are aimed.
  void solve_before(double h);
  // After the drift.
  void close_gaps(double h);
  void turn_to_now(double h);
  void solve_after(double h);
  void end_step();

 private:
  struct Row {
    Link* link = nullptr;
    JointRow row;
    Vec3 shift_a, turn_a, shift_b, turn_b;  // what an impulse of 1 does to both bodies
    Vec3 twist;                             // and how it twists a about the anchor
  };
  void find_bodies();
  void gather();
  void find_pattern();
  void factor();
  void note_stiffness(double h);
  void stiffen(double h);
  Row with_response(Link& link, const JointRow& row) const;
  void couple(Drive& drive);
  void close_bends(double h);
  void drift_along(const Row& row, double shift, double h);
  void close_rest();
  double most_repair() const;
  double find_gaps();
  double repair(double most_cost);
  void move(double rate);
  void solve_drives();
  double beside(const Drive& spring) const;
  double drive_once(Drive& drive);
  void give(const Row& row, double impulse) const;

  std::vector<Link*> links_;
  std::vector<Mover*> bodies_;   // that can be pushed, each once
  std::vector<Row> rows_;
  std::vector<Row> drive_rows_;  // one a drive
  std::vector<Drive> drives_;
  std::vector<std::pair<int, int>> pattern_;
  std::vector<double> values_;
  Eigen::VectorXd gaps_, shifts_, impulses_;  // of the rows
  Eigen::VectorXd held_;         // impulses along the rows in this substep
  Eigen::VectorXd pull_;         // of the whole of the last one
  Factor factor_;
  int regular_ = 0;              // how much repairs add to the diagonal: which of a few parts
  int factored_ = 0;             // the one with which factor_ was made
  int since_less_ = 0;           // substeps
  double whip_ = 0;
  EnergyBook energy_;
  bool conserves_ = false;       // so far in this step, has nothing but constant forces done work?
  bool tree_ = false;            // are there no loops? All that cannot be pushed is one body
  bool aimed_ = false;
  bool refreshed_ = false;       // are rows and gaps those of the bodies' poses?
};

}  // namespace tumble::dynamics
