// The same scene gives the same numbers to the last bit: twice in one process, in another process, and after another
// history of allocations. Replays and tests of games rest on it.
#include <cstring>

#include "accuracy/cases/life/process.h"
#include "accuracy/cases/life/verdict.h"
#include "base/hash.h"

namespace tumble::accuracy {

namespace {

using Hashes = std::vector<std::uint64_t>;  // one a step, of all poses

// A pyramid of base `base` and a bridge of planks with cubes falling on it; from time to time a body goes.
Hashes play(Simulation& scene, int base, double seconds, double drop) {
  add_floor(scene);
  std::vector<BodyIndex> bodies;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      bodies.push_back(scene.add(with(dynamic(box({1, 1, 1}), 1), 0.6), {{i * 1.05 + row * 0.525 - base / 2.0, 0.5 + row, -5}, {}}));
  BodyIndex before = scene.add(fixed(box({1, 0.2, 1})), {{-8, 4, 5}, {}});
  for (int i = 1; i <= 15; ++i) {
    bodies.push_back(scene.add(with(dynamic(box({0.98, 0.2, 1}), 4), 0.6), {{-8.0 + i, 4, 5}, {}}));
    scene.add(joint(before, bodies.back(), {0.5, 0, 0}, HingeDef{}, {0, 0, 1}));
    before = bodies.back();
  }
  scene.add(joint(before, scene.add(fixed(box({1, 0.2, 1})), {{8, 4, 5}, {}}), {0.5, 0, 0}, HingeDef{}, {0, 0, 1}));
  Chance chance(30);
  for (int i = 0; i < 10; ++i)
    bodies.push_back(scene.add(with(dynamic(i % 2 ? ball(0.3) : box({0.5, 0.5, 0.5}), 1), 0.5), {{chance.between(-6, 6), drop + i, 5}, chance.rotation()}));

  Hashes hashes;
  run(scene, seconds, kFrame, [&](double) {
    if (hashes.size() % 20 == 19) {
      const auto gone = bodies.begin() + static_cast<long>(chance.unit() * static_cast<double>(bodies.size()));
      scene.remove(*gone);
      bodies.erase(gone);
    }
    Hash hash;
    for (const BodyIndex body : bodies) {
      const Pose pose = scene.pose(body);
      hash.add(pose.position).add(pose.rotation);
    }
    hashes.push_back(hash.value());
    return true;
  });
  return hashes;
}

Hashes play(Trial& trial, double drop) {
  const bool test = trial.effort() == Effort::test;
  return play(trial.scene(), trial.full() ? 20 : test ? 3 : 5, trial.shortened(10, test ? 0.7 : 2), drop);
}

// Large enough to be shared: 300 boxes at least.
Hashes play_large(Trial& trial, double drop, int threads) {
  SceneSettings settings;
  settings.threads = threads;
  return play(trial.scene(settings), trial.full() ? 40 : 24, trial.shortened(5, trial.effort() == Effort::test ? 0.4 : 1), drop);
}

Outcome compare(const Hashes& a, const Hashes& b) {
  Verdict verdict;
  if (!verdict.require(a.size() == b.size() && !a.empty(), "one run ended early")) return verdict.outcome;
  std::size_t step = 0;
  while (step < a.size() && a[step] == b[step]) ++step;
  verdict.require(step == a.size(), "differs from " + in_seconds(static_cast<double>(step) * kFrame) + " on");
  return verdict.outcome;
}

constexpr double kDrop = 6;  // m

Outcome twice(Trial& trial) {
  const Hashes first = play(trial, kDrop);
  return compare(first, play(trial, trial.reference(kDrop)));
}

Outcome other_history(Trial& trial) {
  const Hashes first = play(trial, kDrop);
  Chance chance(7);
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 20000; ++i) blocks.push_back(std::make_unique<char[]>(static_cast<std::size_t>(chance.between(16, 3000))));
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (chance.unit() < 0.5) blocks[i].reset();
  return compare(first, play(trial, trial.reference(kDrop)));
}

Outcome two_threads(Trial& trial) {
  const Hashes two = play_large(trial, kDrop, 2);
  return compare(play_large(trial, trial.reference(kDrop), 1), two);
}

Outcome new_process(Trial& trial) {
  const std::optional<std::string> bytes = in_new_process([&] {
    const Hashes there = play(trial, trial.reference(kDrop));
    return std::string(reinterpret_cast<const char*>(there.data()), there.size() * sizeof there[0]);
  });
  Hashes there(bytes.value_or("").size() / sizeof(Hashes::value_type));
  if (!there.empty()) std::memcpy(there.data(), bytes->data(), bytes->size());
  return compare(play(trial, kDrop), there);
}

}  // namespace

Case b30_determinism() {
  return {"B30", "Determinism", "a pyramid, a bridge of hinges under falling bodies, a body removed every 20 steps", "S: the same run again",
          "10 where the hash of all poses differs at any step, else 0",
          {{"twice", 1, twice},
           {"new process", 1, new_process},
           {"other allocations", 1, other_history},
           {"1 and 2 threads", 1, two_threads}}};
}

}  // namespace tumble::accuracy
