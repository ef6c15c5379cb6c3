// pack: a game as one file, in two forms: a program with the game behind it, and a package for `play`.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/program.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

struct Pack {
  std::string game, output, name;
};

void check_name(const std::string& name) {
  const auto bad = [](char c) { return c == '/' || c == '\\' || (static_cast<unsigned char>(c) < 32); };
  if (name.empty() || name.front() == '.' || name.front() == '-' || std::any_of(name.begin(), name.end(), bad))
    throw Error("pack: --name: '" + name + "' cannot be a file's name; take letters, digits and spaces");
}

// Packs and runs a first copy, as a classmate would, so that an earlier good package is not lost to a game that fails.
void prove(const Pack& order) {
  const fs::path copy = fs::absolute(order.output) / (".trial " + std::to_string(getpid()));
  pack(order.game, copy.string(), own_program().string());
  const int status = run_program({copy.string(), "--headless", "--ticks", "60"}, [](const std::string&) {});
  fs::remove(copy);
  if (status != 0)
    throw Error("pack: the packed game did not run for 60 ticks (status " + std::to_string(status) +
                ", see above), so nothing was written; play it first: tumble play " + shell_word(order.game) + " --headless --ticks 60");
}

std::string size_text(const fs::path& file) {
  char text[32];
  const double kilobytes = static_cast<double>(fs::file_size(file)) / 1e3;
  std::snprintf(text, sizeof text, kilobytes < 1000 ? "%.1f kB" : "%.1f MB", kilobytes < 1000 ? kilobytes : kilobytes / 1e3);
  return text;
}

int pack_game(Pack order) {
  if (order.name.empty()) order.name = game_name(order.game);
  check_name(order.name);
  if (!fs::is_directory(order.game)) throw Error("pack: '" + order.game + "' is no folder; give a game's folder, such as games/basketball");
  std::error_code error;
  fs::create_directories(order.output, error);
  if (!fs::is_directory(order.output)) throw Error("pack: --output: the folder '" + order.output + "' cannot be made; give a folder that you may write to");
  const fs::path program = fs::path(order.output) / order.name, package = fs::path(order.output) / (order.name + ".tumble");
  prove(order);
  pack(order.game, program.string(), own_program().string());
  pack(order.game, package.string());
  std::cout << "'" << program.string() << "' (" << size_text(program) << ") runs by itself on a Linux with SDL2, libzip and libvorbis (libsdl2-2.0-0, libzip4, libvorbisfile3); '" << package.string() << "' (" << size_text(package)
            << ") is opened by play. A copy was run for 60 ticks.\n";
  return 0;
}

}  // namespace

void add_pack(CLI::App& app, int& status) {
  auto order = std::make_shared<Pack>();
  CLI::App* verb = app.add_subcommand("pack", "Make one file of a game: a program that runs by itself, and NAME.tumble");
  verb->add_option("game", order->game, "The game's folder")->required()->type_name("GAME");
  verb->add_option("--output", order->output, "The folder for both files; made where it is missing")->required()->type_name("DIR");
  verb->add_option("--name", order->name, "Their name (the folder's)")->type_name("NAME");
  verb->callback([order, &status] { status = pack_game(*order); });
}

}  // namespace tumble::cli
