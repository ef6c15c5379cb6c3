// test: every test there is, one part of them, or a game's own; closes with a line that counts test cases.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/program.h"
#include "cli/tests.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

#ifdef TUMBLE_SANITIZED
constexpr bool kSanitized = true;
// Programs of others would have to be built for it too, and the suite would take an hour.
const char* const kShellTests[] = {"tests/cli"};
#else
constexpr bool kSanitized = false;
const char* const kShellTests[] = {"tests/cli", "tests/window", "tests/embed", "tests/accuracy"};
#endif

bool is_game(const fs::path& folder) { return fs::exists(folder / "main.lua") || fs::exists(folder / "game.json"); }

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> list;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_directory()) list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

void run_lua_suite(const fs::path& folder, Tally& tally) {
  if (folder.filename() != "errors") return run_game_tests(folder, tally);
  run_error_scripts(folder, false, tally);
  run_error_scripts(folder / "drawn", true, tally);
}

// From inside the tree, so that names are short: tests/lua/api, games/basketball.
void run_all(Tally& tally) {
  run_cpp_tests("", tally);
  for (const fs::path& suite : folders_in("tests/lua")) run_lua_suite(suite, tally);
  for (const fs::path& game : folders_in("games"))
    if (fs::is_directory(game / "tests")) run_game_tests(game, tally);
  for (const char* folder : kShellTests) run_shell_tests(folder, tally);
}

// By its name: a folder of shell tests, a suite of tests/lua, or C++ tests by tag or by how their titles begin.
void run_part(const std::string& part, Tally& tally) {
  for (const char* folder : kShellTests)
    if (fs::path(folder).filename() == part) return run_shell_tests(folder, tally);
  const fs::path suite = fs::path("tests/lua") / part;
  const bool known = fs::is_directory(suite);
  if (known) run_lua_suite(suite, tally);
  if (known && !fs::is_directory(fs::path("tests") / part)) return;
  run_cpp_tests("[" + part + "]," + part + "*", tally);
  if (tally.passed + tally.failed == 0) throw Error("test: no part '" + part + "'; give a folder of tests or tests/lua, or a game's folder");
}

int test(const std::string& what, bool sanitize) {
  if (sanitize && !kSanitized) throw Error("test: --sanitize needs a build of its own, which the launcher makes: ./tumble test --sanitize");
  Tally tally;
  if (!what.empty() && fs::is_directory(what) && is_game(what)) {
    run_game_tests(what, tally);
  } else {
    fs::current_path(source_tree("test"));
    if (what.empty()) run_all(tally);
    else run_part(what, tally);
  }
  std::cout << '\n' << tally.passed << " passed, " << tally.failed << " failed\n";
  return tally.failed == 0 && tally.passed > 0 ? 0 : 1;
}

}  // namespace

void add_test(CLI::App& app, int& status) {
  auto what = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("test", "Run all tests, one part of them (physics, script, embed ...), or a game's own");
  verb->add_option("what", *what, "Nothing: all of them")->type_name("PART|GAME");
  auto sanitize = std::make_shared<bool>(false);
  verb->add_flag("--sanitize", *sanitize, "Looks for misused memory and undefined sums too (build/sanitize, a quarter of an hour)");
  verb->callback([what, sanitize, &status] { status = test(*what, *sanitize); });
}

}  // namespace tumble::cli
