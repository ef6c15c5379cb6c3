// A step of the world's dynamics: takes bodies, contacts and joints from Bullet's world into plain numbers, moves them
// through the substeps, and writes them back.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "physics/bullet/joint_part.h"
#include "physics/bullet/step_contacts.h"
#include "physics/dynamics/heap.h"

namespace tumble {

struct WorldSettings;

class Solver {
 public:
  // Joints came, went, or hold other bodies.
  void joints_changed() { mechanisms_known_ = false; }

  // After collision detection. `live` are the joints that hold.
  void begin(const WorldSettings& settings, const std::vector<BodyState*>& awake, const std::vector<BodyState*>& carriers,
             const std::vector<JointPart*>& live, Collision& collision, double seconds);
  // Each island with as many substeps as it needs, `least` and more; the team shares them, and the large ones' contacts.
  void run(double seconds, int least, int rounds, Team& team);
  void end(double seconds);
  // How many islands the last step had; BodyState::island is one of them.
  int islands() const { return static_cast<int>(islands_.size()); }
  int most_substeps() const { return most_substeps_; }  // that one of them took

 private:
  dynamics::Mover& add_mover(BodyState& body);
  dynamics::Mover& mover_of(const BodyState* body);
  void gather_bodies(const WorldSettings& settings, const std::vector<BodyState*>& awake, const std::vector<BodyState*>& carriers, double seconds);
  void find_mechanisms(const std::vector<JointPart*>& live);
  void gather_mechanisms(const std::vector<JointPart*>& live);

  std::deque<dynamics::Mover> movers_;
  std::vector<BodyState*> bodies_;        // of each mover but the first, which is all that cannot move
  StepContacts contacts_;
  std::vector<std::unique_ptr<dynamics::Mechanism>> mechanisms_;  // of the joints that share bodies
  std::vector<dynamics::Mechanism*> awake_;
  std::vector<dynamics::Island> islands_;
  std::vector<dynamics::Island*> small_;  // that are not in a heap
  std::vector<int> substeps_;             // of each of those
  std::map<int, std::unique_ptr<dynamics::Heap>> heaps_;  // by their number of substeps
  bool mechanisms_known_ = false;
  int most_substeps_ = 0;
};

}  // namespace tumble
