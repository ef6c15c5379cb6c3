// bench: the figures of tests/bench, from the program that looks inside, in a build's folder beside ours.
#include <filesystem>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/program.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

int bench(const std::vector<std::string>& parts, const std::string& json) {
  const fs::path program = own_program().parent_path() / "tumble_bench";
  if (!fs::exists(program))
    throw Error("bench: '" + program.string() + "' is missing; build it with: ninja -C " + shell_word(program.parent_path().string()) + " tumble_bench");
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), parts.begin(), parts.end());
  if (!json.empty()) words.insert(words.end(), {"--json", json});
  return run_program(words) == 0 ? 0 : 1;
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
  auto parts = std::make_shared<std::vector<std::string>>();
  auto json = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("bench", "Measure speed: scripts against C++, drawing, reload, start, collector; each figure with its goal");
  verb->add_option("part", *parts, "Nothing: all of them (lua_nodes, lua_wall, drawing, reload, first_frame, collector, static_nodes)")->type_name("PART");
  verb->add_option("--json", *json, "Write the figures there too: {\"results\": [{\"name\", \"value\", \"unit\", \"goal\", \"how\"}]}")->type_name("FILE");
  verb->callback([parts, json, &status] { status = bench(*parts, *json); });
}

}  // namespace tumble::cli
