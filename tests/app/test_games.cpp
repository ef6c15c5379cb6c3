// The two games through the embedding interface, as their players and authors use them.
#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>

#include "assets/temporary_folder.h"
#include "support/source_tree.h"
#include "tumble/tumble.h"

using namespace tumble;

namespace {

struct Outcome {
  bool finished = false;
  double score = 0;
  int errors = 0;
  std::uint64_t hash = 0;
};

Outcome played(const std::string& game, bool bot, int most_ticks = 7200) {
  Options options;
  options.bot = bot;
  Runtime runtime(options);
  runtime.load(source_tree("games/" + game).string());
  while (!runtime.is_finished() && runtime.tick_number() < most_ticks) runtime.tick();
  return {runtime.is_finished(), runtime.report("score").number_or(0), runtime.script_errors(), runtime.hash()};
}

// Other than the bot's input: the pointer drawn a little to the side in every throw.
double score_of_crooked_throws() {
  Runtime runtime;
  runtime.load(source_tree("games/basketball").string());
  runtime.tick(2);           // the title stands, with the focus on Play
  runtime.press("space");
  runtime.tick(2);
  runtime.release("space");
  while (!runtime.is_finished() && runtime.tick_number() < 7200) {
    runtime.press("pointer", {640, 300});
    runtime.tick(2);
    runtime.move_pointer({600, 420});
    runtime.tick(2);
    runtime.release("pointer");
    runtime.tick(150);
  }
  CHECK(runtime.is_finished());
  return runtime.report("score").number_or(-1);
}

// A copy of a game that may be edited, and its runtime, which watches it.
struct Edited {
  TemporaryFolder folder;
  Runtime runtime;
  std::string log;
  std::vector<ScriptError> errors;

  explicit Edited(const std::string& game) : runtime(watching()) {
    std::filesystem::copy(source_tree("games/" + game), folder.path(), std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    runtime.on_log([this](LogLevel, const std::string& text) { log += text + "\n"; });
    runtime.on_script_error([this](const ScriptError& error) { errors.push_back(error); });
    runtime.load(folder.path().string());
  }
  static Options watching() {
    Options options;
    options.watch = true;
    return options;
  }
  // As most editors save: a new file beside the old one, then a rename over it.
  void save(const std::string& file, const std::string& text) {
    folder.write(".saving.tmp", text);
    std::filesystem::rename(folder / ".saving.tmp", folder / file);
  }
  std::string replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = folder.read(file);
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    save(file, text.replace(at, from.size(), to));
    return text;
  }
};

double run_for(Runtime& runtime, int ticks) {
  const Vec3 before = runtime.node("player").position();
  runtime.tick(ticks);
  const Vec3 after = runtime.node("player").position();
  return std::hypot(after.x - before.x, after.z - before.z);
}

}  // namespace

TEST_CASE("games: the bot plays each to its end, twice to the same hash", "[games]") {
  for (const char* game : {"basketball", "platformer"}) {
    INFO(game);
    const Outcome first = played(game, true), second = played(game, true);
    CHECK(first.finished);
    CHECK(first.score > 0);
    CHECK(first.errors == 0);
    CHECK(first.hash == second.hash);
  }
}

TEST_CASE("games: without the bot none is finished, and other input gives another score", "[games]") {
  CHECK_FALSE(played("basketball", false).finished);
  CHECK_FALSE(played("platformer", false).finished);
  CHECK(score_of_crooked_throws() != played("basketball", true).score);
}

TEST_CASE("games: a saved number changes the platformer while it plays, and place and time are kept", "[games]") {
  Edited game("platformer");
  Runtime& runtime = game.runtime;
  runtime.tick(2);           // the title is there
  runtime.press("space");
  runtime.tick(1);
  runtime.release("space");
  runtime.tick(60);
  runtime.press("s");        // away from the ramp, over flat ground
  runtime.tick(20);
  const double slow = run_for(runtime, 20);
  runtime.release("s");
  runtime.press("w");
  runtime.tick(30);
  const Vec3 before = runtime.node("player").position();
  const double seconds = runtime.report("seconds").number_or(-1);

  game.replace("player.lua", "speed = 6", "speed = 3");
  runtime.tick(1);
  const Vec3 after = runtime.node("player").position();
  runtime.tick(20);
  const double slower = run_for(runtime, 20);

  CHECK(game.log.find("reloaded player.lua: player.speed = 3") != std::string::npos);
  CHECK(std::hypot(after.x - before.x, after.z - before.z) < 0.12);   // at most a tick at 6 m/s, with a little more
  CHECK(runtime.report("seconds").number_or(-1) > seconds);
  CHECK(slow == Approx(2.0).margin(0.1));     // 20 ticks at 6 m/s
  CHECK(slower == Approx(1.0).margin(0.05));  // and at 3 m/s
  CHECK(game.errors.empty());
}

TEST_CASE("games: a syntax error is told, the old code plays on, and the mend is taken", "[games]") {
  Edited game("platformer");
  Runtime& runtime = game.runtime;
  runtime.tick(2);           // the title is there
  runtime.press("space");
  runtime.tick(1);
  runtime.release("space");
  runtime.tick(30);
  const std::string good = game.folder.read("player.lua");

  game.replace("player.lua", "function Player:update()", "function Player:update(");
  runtime.press("s");
  runtime.tick(1);
  const double moved = run_for(runtime, 30);
  REQUIRE(game.errors.size() == 1);
  CHECK(game.errors[0].file == "player.lua");
  CHECK(game.errors[0].line > 0);
  CHECK(moved > 1);

  game.save("player.lua", good);
  runtime.tick(1);
  CHECK(game.log.find("reloaded player.lua") != std::string::npos);
  CHECK(game.errors.size() == 1);
}
