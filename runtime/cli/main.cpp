// The program `tumble`: a host like any other, which sees tumble.h only. With a game behind it, it is that game.
#include <iostream>

#include "cli/commands/commands.h"
#include "cli/program.h"
#include "tumble/tumble.h"

namespace {

void describe_verbs(CLI::App& app, int& status) {
  app.require_subcommand(1);
  app.set_version_flag("--version", "tumble " + tumble::version());
  tumble::cli::add_play(app, status);
  tumble::cli::add_new(app, status);
  tumble::cli::add_test(app, status);
  tumble::cli::add_check(app, status);
  tumble::cli::add_measure(app, status);
  tumble::cli::add_bench(app, status);
  tumble::cli::add_pack(app, status);
  tumble::cli::add_docs(app, status);
}

// CLI11 would only say that a verb is missing.
void check_verb(const CLI::App& app, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.empty() || word.front() == '-') return;
  std::string known;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_name() == word) return;
    known += (known.empty() ? "" : ", ") + verb->get_name();
  }
  throw tumble::Error("tumble: no verb '" + word + "'; the verbs are " + known);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tumble: small 3D games with physics, scripted in Lua.", "tumble");
  int status = 0;
  try {
    const std::string program = tumble::cli::own_program().string();
    if (tumble::has_packed_game(program)) {
      tumble::cli::add_packed_play(app, program, status);
    } else {
      describe_verbs(app, status);
      check_verb(app, argc, argv);
    }
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 1 : 0;
  } catch (const std::exception& error) {
    std::cout.flush();
    std::cerr << error.what() << '\n';
    return 1;
  }
  return status;
}
