// check, first form: the scripts run for one tick, so it finds what the top levels, start() and one update do wrong.
#include <iostream>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/program.h"

namespace tumble::cli {

namespace {

int check_game(const std::string& game) {
  Runtime runtime;
  show_messages(runtime);
  runtime.load(game);
  if (runtime.is_loaded()) runtime.tick();
  const int errors = runtime.script_errors();
  if (errors == 0 && runtime.is_loaded()) std::cout << "'" << game << "': no error in its first tick\n";
  else std::cout << "'" << game << "': " << count_text(errors, "error") << '\n';
  return errors == 0 && runtime.is_loaded() ? 0 : 1;
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  auto game = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("check", "Run a game for one tick without a window and report its errors; it does not look further");
  verb->add_option("game", *game, "The game")->required()->type_name("GAME");
  verb->callback([game, &status] { status = check_game(*game); });
}

}  // namespace tumble::cli
