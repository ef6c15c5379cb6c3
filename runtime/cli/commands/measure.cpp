// measure, first form: what a tick of a game costs, without drawing.
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/program.h"
#include "cli/timing.h"

namespace tumble::cli {

namespace {

struct Measure {
  std::string game;
  int ticks = 600;
  bool bot = false;
};

int measure_game(const Measure& measure) {
  Options options;
  options.bot = measure.bot;
  Runtime runtime(options);
  show_messages(runtime);
  runtime.load(measure.game);
  const Timing timing = time_ticks(runtime, measure.ticks);
  if (timing.ticks == 0) return 1;
  const double whole = runtime.tick_seconds() * 1e3;
  std::printf("'%s', %s without drawing, processor time of a tick:\n\n", measure.game.c_str(), count_text(timing.ticks, "tick").c_str());
  std::printf("  median       %8.3f ms   %5.1f %% of the %.2f ms that a tick lasts\n", timing.median, timing.median / whole * 100, whole);
  std::printf("  99 of 100    %8.3f ms   at most\n", timing.most_of_99);
  std::printf("  worst        %8.3f ms\n", timing.worst);
  return runtime.script_errors() == 0 ? 0 : 1;
}

}  // namespace

void add_measure(CLI::App& app, int& status) {
  auto measure = std::make_shared<Measure>();
  CLI::App* verb = app.add_subcommand("measure", "Tell what a tick of a game costs; speed only, no accuracy yet");
  verb->add_option("game", measure->game, "The game")->required()->type_name("GAME");
  verb->add_option("--ticks", measure->ticks, "How many ticks (600)")->check(CLI::PositiveNumber);
  verb->add_flag("--bot", measure->bot, "Let the game's bot.lua play");
  verb->callback([measure, &status] { status = measure_game(*measure); });
}

}  // namespace tumble::cli
