#include "accuracy/runner/cost.h"

#include <algorithm>

#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kBlockMs = 4;   // at least: the clock's own cost then is a part in ten thousand
constexpr int kFewestBlocks = 3;
constexpr int kWarmTicks = 10;

// A recorded scene on its way through an engine.
class Playback {
 public:
  Playback(const Recorder& scene, const EngineKind& engine, const Knobs& knobs) : script_(scene.script()), world_(engine.make(scene.settings(), knobs)) {}

  // Up to so many ticks, with what happens between them; how many there were.
  int play(int ticks) {
    int done = 0;
    while (done < ticks && at_ < script_.size()) {
      const Operation& next = script_[at_];
      if (next.change) {
        next.change(*world_);
        ++at_;
        continue;
      }
      world_->step(next.seconds);
      ++done;
      if (++step_ == next.steps) {
        step_ = 0;
        ++at_;
      }
    }
    return done;
  }

 private:
  const Script& script_;
  std::unique_ptr<Simulation> world_;
  std::size_t at_ = 0;
  int step_ = 0;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// The interval in which 95 of 100 medians of resampled ratios lie.
void bootstrap(const std::vector<double>& ratios, Cost& cost) {
  Chance chance(7);
  std::vector<double> medians;
  for (int round = 0; round < 200; ++round) {
    std::vector<double> sample(ratios.size());
    for (double& s : sample) s = ratios[static_cast<std::size_t>(chance.unit() * static_cast<double>(ratios.size()))];
    medians.push_back(median(sample));
  }
  std::sort(medians.begin(), medians.end());
  cost.ratio = median(ratios);
  cost.low = medians[5];
  cost.high = medians[194];
}

}  // namespace

std::optional<Cost> measure_cost(const Recorder& scene, const EngineKind& engine, const Knobs& knobs, double budget_ms) {
  if (scene.steps() < 2 * kWarmTicks) return {};
  const EngineKind& stock = engines().back();
  const bool itself = engine.name == stock.name && knobs == stock.defaults;
  std::unique_ptr<Playback> a = std::make_unique<Playback>(scene, engine, knobs), b;
  // Stock may refuse what the other engine took, at any time of the scene.
  const auto beside = [&](const auto& play) -> double {
    try {
      return play();
    } catch (const Missing&) {
    } catch (const std::exception&) {
    }
    b.reset();
    return 0;
  };
  if (!itself)
    beside([&] {
      b = std::make_unique<Playback>(scene, stock, stock.defaults);
      return b->play(kWarmTicks);
    });
  a->play(kWarmTicks);

  // A block is as long as the clock needs, judged by the recording itself.
  const double tick_ms = std::max(1e-4, scene.step_ms() / scene.steps());
  const int block = std::max(1, std::min(static_cast<int>(kBlockMs / tick_ms) + 1, (scene.steps() - kWarmTicks) / kFewestBlocks));
  std::vector<double> ticks_us, ratios;
  const auto timed = [block](Playback& playback) {
    const double begin = thread_ms();
    const int ticks = playback.play(block);
    return ticks == block ? (thread_ms() - begin) * 1e3 / block : -1;
  };
  const double begin = thread_ms();
  for (bool first = true; thread_ms() - begin < budget_ms || static_cast<int>(ticks_us.size()) < kFewestBlocks; first = !first) {
    double ours = 0, theirs = 0;
    if (b && !first) theirs = beside([&] { return timed(*b); });
    ours = timed(*a);
    if (b && first) theirs = beside([&] { return timed(*b); });
    if (ours < 0 || theirs < 0) break;
    ticks_us.push_back(ours);
    if (b && theirs > 0) ratios.push_back(ours / theirs);
  }
  if (ticks_us.empty()) return {};
  Cost cost;
  cost.us_per_tick = median(ticks_us);
  if (itself) cost.ratio = cost.low = cost.high = 1;
  else if (!ratios.empty()) bootstrap(ratios, cost);
  return cost;
}

}  // namespace tumble::accuracy
