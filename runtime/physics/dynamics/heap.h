// Islands of many contacts and no joints: the same substeps as in island.h, four contacts at a time.
//
// What is dearer than a heap needs is left out: normals, arms and friction's place stay for the whole step as the look
// found them, only separations follow; numbers are floats; friction is one ellipsoid; nothing bounces. Positions stay
// double. Where that is not enough, is_heap() says no.
#pragma once

#include <atomic>
#include <vector>

#include "base/team.h"
#include "physics/dynamics/batch.h"
#include "physics/dynamics/island.h"

namespace tumble::dynamics {

template <class F>
class HeapOf {
 public:
  // One or more islands that take the same number of substeps; none of them knows of the others.
  void add(Island& island);
  // All that was added, which is forgotten then. The team shares what is independent: bodies, or contacts of a color.
  void run(double seconds, int substeps, int rounds, Team& team);

 private:
  struct Record {
    Mover* mover;
    Vec3 across[3];          // principal axes over the roots of their moments: from a moment to scaled spin
    double root_mass;        // of the inverse mass
    Quat turned;             // in the step
    Vec3 scaled(Vec3 moment) const { return {dot(across[0], moment), dot(across[1], moment), dot(across[2], moment)}; }
  };
  struct Drive {             // of a scaled motion in a substep, without contacts: velocity * kept + gained
    Motion kept, gained;
    Motion mean_kept, mean_gained;  // from the velocity at the end to the mean, if nothing touches it
  };
  struct Member {            // a contact, and where its numbers are
    Contact* contact;
    int color = 0, batch = 0, lane = 0;
    double lever = 0;        // m, of the friction
  };

  static int index_of(const Mover& mover) { return mover.pushable ? mover.record : 0; }
  const Record& record_of(const Mover& mover) const { return records_[static_cast<std::size_t>(index_of(mover))]; }
  void set_up(double h, Team& team);
  void set_drive(std::size_t i, double h);
  void color();
  void sort_members();
  void make_batches();
  void fill(Batch<F>& batch, int lane, Member& member, double h);
  void fill_friction(Batch<F>& batch, int lane, Member& member, double h);
  void kick(std::size_t i);
  void drift(std::size_t i, float h);
  void hold(std::size_t i);
  bool find_stirred(const Batch<F>& batch, int round, F& lanes) const;
  bool solve_batch(Batch<F>& batch, int round, int least, const Aim& aim);
  void solve_in_rounds(int least, const Aim& aim, Team& team);
  void move(Record& record, const Motion& way, const Motion& velocity) const;
  void finish(double seconds, double h, Team& team);
  template <class Each>
  void each_body(Team& team, const Each& each);
  template <class Each>
  void each_batch(Team& team, const Each& each);
  template <class Each>
  void each_by_color(Team& team, const Each& each);
  void read_back(const Member& member, double seconds, double h);

  std::vector<Record> records_;
  std::atomic<bool> blow_ = false;  // did one go through it in this substep?
  double deep_ = 0;  // contacts of bodies, counted at both, also those that were left out: see Crowd
  std::vector<Drive> drives_;
  std::vector<Motion> velocities_, free_, held_, ways_;  // without contacts, and what these gave in the substep before
  std::vector<int> stirred_;  // the last round that changed a body's velocity much
  std::vector<Member> members_, sorted_;
  std::vector<Batch<F>> batches_;
  std::vector<std::size_t> colors_, members_of_;  // where each color's batches begin, and each batch's members; and the ends
  std::vector<PointRow<F>> rows_;
};

using Heap = HeapOf<Four>;

// Is it large and plain enough?
bool is_heap(const Island& island);
// At most so many rounds, which are ended when no speed changes much: with so many contacts, and so many to each body.
constexpr int kFewRounds = 4;
int most_rounds(double contacts, double around, int least);

extern template class HeapOf<Four>;
extern template class HeapOf<float>;

}  // namespace tumble::dynamics
