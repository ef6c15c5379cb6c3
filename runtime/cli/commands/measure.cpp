// measure: without a game, speed against error of the physics (the suite in tests/accuracy, by the program that looks
// inside); of a game, what its ticks cost, without drawing.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "cli/commands/commands.h"
#include "cli/program.h"
#include "cli/timing.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

struct Measure {
  std::string game, csv;
  int ticks = 600;
  bool bot = false;
  std::vector<std::string> suite;  // words for the suite's program
};

// What the suite's program takes; the same words do nothing for a game and are refused there.
struct SuiteOption {
  const char *name, *value, *help;
};
constexpr SuiteOption kSuiteOptions[] = {
    {"--quick", "", "The suite in at most three minutes; shortened runs say so (the default)"},
    {"--full", "", "The suite at every setting that 40 s a case and engine allow: up to two hours"},
    {"--soak", "", "Those cases too that take minutes to hours"},
    {"--list", "", "Name the cases, their truth and their error"},
    {"--case", "ID", "Only these cases: A03 or A03,B01"},
    {"--engine", "NAME", "Only this engine: tumble or stock (Debian's Bullet as it comes)"},
    {"--seconds", "S", "Processor time for the settings of a case on an engine (1.2 quick, 40 full)"},
    {"--default-only", "", "Each engine's default setting only, no sweep"},
    {"--knobs", "SxI", "Other substeps and iterations in place of our default: 4x1"},
    {"--perturb", "PART", "Spoil every reference by this part of itself: a case that passes must then fail"},
    {"--instructions", "", "Count instructions by valgrind as well"},
    {"--rows", "FILE", "Take the rows of this CSV instead of running"},
    {"--report", "DIR", "Write the report, index.html with its plots, into this folder"},
    {"--compare", "", "Say what got better or worse since the baseline; status 1 where something got worse"},
    {"--baseline", "DIR", "The baseline to compare with (tests/accuracy/baseline)"},
};

std::string tick_table(const Measure& measure, const Timing& timing, double whole) {
  std::ostringstream out;
  out << "game,ticks,median_ms,p99_ms,worst_ms,tick_ms\n"
      << '"' << measure.game << "\"," << timing.ticks << ',' << timing.median << ',' << timing.most_of_99 << ',' << timing.worst << ',' << whole << '\n';
  return out.str();
}

int measure_game(const Measure& measure) {
  if (!measure.suite.empty()) throw Error("measure: " + measure.suite.front() + " belongs to the suite, which runs without a game; leave one of both out");
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
  if (!measure.csv.empty()) write_file(measure.csv, tick_table(measure, timing, whole), "measure: --csv");
  return runtime.script_errors() == 0 ? 0 : 1;
}

int measure_suite(const Measure& measure) {
  const fs::path program = own_program().parent_path() / "tumble_measure";
  if (!fs::exists(program))
    throw Error("measure: '" + program.string() + "' is missing; build it with: ninja -C " + shell_word(program.parent_path().string()) + " tumble_measure");
  const std::string tree = source_tree("measure").string();
  std::string commit;
  run_program({"git", "-C", tree, "rev-parse", "--short", "HEAD"}, [&](const std::string& line) { commit = " " + line; });
  std::vector<std::string> words = {program.string(), "--revision", version() + commit};
  words.insert(words.end(), measure.suite.begin(), measure.suite.end());
  if (!measure.csv.empty()) words.insert(words.end(), {"--csv", measure.csv});
  if (std::find(words.begin(), words.end(), "--baseline") == words.end())
    words.insert(words.end(), {"--baseline", tree + "/tests/accuracy/baseline"});
  return run_program(words);
}

}  // namespace

void add_measure(CLI::App& app, int& status) {
  auto measure = std::make_shared<Measure>();
  CLI::App* verb = app.add_subcommand("measure", "Measure speed against error of the physics, or what a tick of a game costs");
  verb->add_option("game", measure->game, "The game; without one the suite runs")->type_name("GAME");
  verb->add_option("--csv", measure->csv, "Write the figures there too")->type_name("FILE");
  verb->add_option("--ticks", measure->ticks, "Of a game: how many ticks (600)")->check(CLI::PositiveNumber);
  verb->add_flag("--bot", measure->bot, "Of a game: let its bot.lua play");
  for (const SuiteOption& option : kSuiteOptions) {
    const std::string name = option.name;
    if (*option.value == 0) {
      verb->add_flag_callback(name, [measure, name] { measure->suite.push_back(name); }, option.help);
    } else {
      const auto take = [measure, name](const std::string& value) { measure->suite.insert(measure->suite.end(), {name, value}); };
      verb->add_option_function<std::string>(name, take, option.help)->type_name(option.value);
    }
  }
  verb->callback([measure, &status] { status = measure->game.empty() ? measure_suite(*measure) : measure_game(*measure); });
}

}  // namespace tumble::cli
