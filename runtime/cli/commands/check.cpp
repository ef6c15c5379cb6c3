// check: what can be found without running the game, then luacheck's rules, then what its first tick says.
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <regex>
#include <set>

#include "cli/commands/commands.h"
#include "cli/program.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

// Where several look, a place is told once.
struct Report {
  std::set<std::pair<std::string, int>> places;
  int errors = 0, warnings = 0;

  // `again`: although something else was told of that line.
  void tell(const std::string& file, int line, const std::string& text, bool is_error, bool again = false) {
    if (line > 0 && !places.emplace(file, line).second && !again) return;
    std::cout << file << ':' << (line > 0 ? std::to_string(line) + ":" : "") << ' ' << (is_error ? "" : "warning: ") << text << '\n';
    ++(is_error ? errors : warnings);
  }
};

struct TemporaryFile {
  std::string path = (fs::temp_directory_path() / "tumble.XXXXXX").string();
  explicit TemporaryFile(const std::string& text) {
    const int file = mkstemp(path.data());
    if (file < 0) throw Error("check: no file can be made in '" + fs::temp_directory_path().string() + "'");
    close(file);
    write_file(path, text, "check");
  }
  ~TemporaryFile() { fs::remove(path); }
};

// Unused and hidden variables, dead code and the like; of names we have told already.
void run_luacheck(const std::string& game, Report& report) {
  if (run_program({"sh", "-c", "command -v luacheck >/dev/null"}) != 0) {
    std::cout << "note: luacheck is not here, so unused variables and the like were not looked for (apt-get install lua-check)\n";
    return;
  }
  const TemporaryFile config(luacheck_config());
  const std::regex line_form(R"(^(.*?):(\d+):\d+: \(([EW])(\d+)\) (.*)$)");
  const fs::path folder = fs::is_directory(game) ? fs::path(game) : fs::path(game).parent_path();
  run_program({"luacheck", game, "--config", config.path, "--no-color", "--codes", "--formatter", "plain", "--no-cache"}, [&](const std::string& line) {
    std::smatch match;
    if (!std::regex_match(line, match, line_form) || match[3] == "E") return;
    report.tell(fs::path(match[1].str()).lexically_relative(folder).generic_string(), std::stoi(match[2]), match[5].str() + " (luacheck " + match[4].str() + ")", false);
  });
}

// What only running tells: options of calls, top levels that do what they must not.
void run_first_tick(const std::string& game, Report& report) {
  Runtime runtime;
  runtime.on_log([&](LogLevel level, const std::string& text) {
    if (level == LogLevel::warning) report.tell("first tick", 0, text, false);
  });
  runtime.on_script_error([&](const ScriptError& error) {
    const std::string place = error.file + ":" + std::to_string(error.line) + ": ";
    report.tell(error.file.empty() ? "first tick" : error.file, error.line, error.text.starts_with(place) ? error.text.substr(place.size()) : error.text, true);
  });
  runtime.load(game);
  if (runtime.is_loaded()) runtime.tick();
}

int check_game(const std::string& game) {
  Report report;
  for (const Finding& found : check(game)) report.tell(found.file, found.line, found.text, found.is_error, true);
  if (!game.ends_with(".tumble")) run_luacheck(game, report);
  try {
    run_first_tick(game, report);
  } catch (const Error& error) {
    if (report.errors == 0) report.tell(game, 0, error.what(), true);
  }
  std::cout << "'" << game << "': " << count_text(report.errors, "error") << ", " << count_text(report.warnings, "warning") << '\n';
  return report.errors == 0 ? 0 : 1;
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  auto game = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("check", "Find mistakes in a game: syntax, unknown names, missing files, scenes that nothing reaches");
  verb->add_option("game", *game, "The game")->required()->type_name("GAME");
  verb->callback([game, &status] { status = check_game(*game); });
}

}  // namespace tumble::cli
