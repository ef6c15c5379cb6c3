// Living particles of all emitters. They are drawn and nothing else: no script reads them, no hash knows them, and their
// chance is a stream of its own, so a game is the same with and without them. Off until somebody draws.
//
// A particle keeps its start and what pulls it; its place at any time follows from the formula of a fall with linear
// drag. So it is where it should be at every frame rate, and a tick only adds the new ones and drops the dead.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/log.h"
#include "engine/random.h"
#include "scene/scene.h"

namespace tumble {

struct DrawParticles;

struct Particle {
  double birth = 0, life = 1;   // s, of the field's own time
  Vec3 position, velocity;      // world, at birth
  Vec3 pull;                    // acceleration, m/s^2
  double damping = 0;           // 1/s
  double size = 0, size_end = 0;
  Color color, color_end;
  double glow = 0;
};
// Where it is `age` seconds after its birth.
Vec3 place_of(const Particle& particle, double age);

class ParticleField {
 public:
  static constexpr std::size_t kMost = 20000;   // alive at once, in a game

  // Someone draws: from now on emitters are noted and simulated. Comes before the first node.
  void set_drawn(bool drawn) { drawn_ = drawn; }
  // This node has the component now.
  void note(NodeId node) { if (drawn_) emitters_.insert(node); }
  // At the end of a tick: new ones begin along the way that their node took in it.
  void step(const Scene& scene, Vec3 gravity, double seconds, const LogSink& log);
  // So many begin at once where the node is now; an emitter that is not playing bursts too.
  void burst(const Scene& scene, NodeId node, int count, Vec3 gravity, const LogSink& log);
  void clear();                 // none is alive; emitters stay

  std::size_t size() const { return count_; }
  // Those of the time between the last step (alpha 0) and this one (alpha 1), in no order, relative to `origin`.
  void draw(double alpha, Vec3 origin, std::vector<DrawParticles>& out) const;

 private:
  struct Group {
    std::string texture;
    double due = 0;             // part of a particle that waits for the next tick
    std::vector<Particle> particles;
  };
  void emit(const Scene& scene, NodeId node, Group& group, Vec3 gravity, const LogSink& log);
  bool add(Group& group, const Particles& look, const Transform& place, double birth, Vec3 gravity);
  void say_full(const Scene& scene, NodeId node, const LogSink& log) const;
  void drop_dead();

  bool drawn_ = false;
  double now_ = 0, step_seconds_ = 0;
  std::size_t count_ = 0;
  std::map<NodeId, Group> groups_;    // of emitters, and of nodes that are gone while particles of theirs live
  std::set<NodeId> emitters_;
  Random random_{4};
};

}  // namespace tumble
