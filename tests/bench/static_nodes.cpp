// Whether nodes that do nothing cost anything.
#include "bench/bench.h"
#include "support/test_game.h"

namespace tumble::bench {

namespace {

constexpr int kTicks = 200, kBlocks = 31;

const char* const kEmpty = "function update(dt) end\n";
const char* const kFull = R"(
function start()
  for i = 1, 10000 do scene.add { position = vec3(i % 100, 0, i // 100), mesh = "box" } end
end
function update(dt) end
)";

}  // namespace

std::vector<Result> static_nodes() {
  TestGame full(Files{{"main.lua", kFull}}), empty(Files{{"main.lua", kEmpty}});
  full.tick(300);   // so that the collector has seen what start() made
  empty.tick(300);
  const Turns turns = take_turns(kBlocks, [&] { full.tick(kTicks); }, [&] { empty.tick(kTicks); });
  return {{"tick_10k_static_ratio", turns.ratio, "ratio", "as close to 1 as can be",
           "a tick of a game with 10 000 nodes that do nothing, over one of an empty game; 31 blocks of 200 ticks in turn, median"},
          {"tick_empty_ms", turns.b / kTicks, "ms", "", "a tick of an empty game"}};
}

}  // namespace tumble::bench
