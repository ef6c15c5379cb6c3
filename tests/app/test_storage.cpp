// What a game stores, from one run to the next: through the embedding interface, in a folder of the test's own.
#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>

#include "app/storage_file.h"
#include "assets/temporary_folder.h"
#include "tumble/tumble.h"

using namespace tumble;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

// Counts its runs, and what it says of itself.
const char* const kCounter = R"(
function start()
  game.report.runs = storage.load("runs", 0) + 1
  storage.save("runs", game.report.runs)
  storage.save("where", { at = vec3(1, 2, 3), paint = color("orange") })
end
)";

struct Machine {
  TemporaryFolder games, kept;
  std::string log;

  Machine() { game("counter", kCounter); }
  void game(const std::string& name, const std::string& main) { games.write(name + "/main.lua", main); }
  Options options() const {
    Options options;
    options.storage = kept.path().string();
    return options;
  }
  // Runs the game for some ticks; what it reports under `runs`.
  double run(const std::string& name, const Options& options, int ticks = 2) {
    Runtime runtime(options);
    runtime.on_log([this](LogLevel, const std::string& text) { log += text + "\n"; });
    runtime.load((games / name).string());
    runtime.tick(ticks);
    CHECK(runtime.script_errors() == 0);
    return runtime.report("runs").number_or(-1);
  }
  double run(const std::string& name = "counter") { return run(name, options()); }
  // The files in the kept folder, relative to it.
  std::vector<std::string> files() const {
    std::vector<std::string> list;
    for (const auto& entry : fs::recursive_directory_iterator(kept.path()))
      if (!entry.is_directory()) list.push_back(fs::relative(entry.path(), kept.path()).string());
    std::sort(list.begin(), list.end());
    return list;
  }
  fs::path file() const { return kept / storage_name("counter", "Tumble", "") / "storage.json"; }
  void put(const std::string& text) { std::ofstream(file(), std::ios::binary) << text; }
};

}  // namespace

TEST_CASE("storage: the next run finds what this one saved", "[app][storage]") {
  Machine machine;

  CHECK(machine.run() == 1);
  CHECK(machine.run() == 2);
  CHECK(machine.run() == 3);
  CHECK(machine.files() == std::vector<std::string>{storage_name("counter", "Tumble", "") + "/storage.json"});
  CHECK(machine.log.empty());
}

TEST_CASE("storage: what is saved is on disk soon after, not only at the end", "[app][storage]") {
  Machine machine;
  Runtime runtime(machine.options());
  runtime.load((machine.games / "counter").string());

  runtime.tick();

  CHECK(read_stored(machine.kept.read(fs::relative(machine.file(), machine.kept.path()).string()), "").values.at("runs") == Value(1));
}

TEST_CASE("storage: restarts of one run go on with what it saved, on disk or not", "[app][storage]") {
  Machine machine;
  for (const bool on_disk : {true, false}) {
    Runtime runtime(on_disk ? machine.options() : Options{});
    runtime.load((machine.games / "counter").string());
    runtime.tick();
    runtime.restart();
    runtime.tick();
    CHECK(runtime.report("runs").number_or(0) == 2);
  }
}

TEST_CASE("storage: a bot begins with nothing and leaves nothing behind", "[app][storage]") {
  Machine machine;
  machine.games.write("counter/bot.lua", "return function() wait(1) end");
  machine.run();
  const std::string before = machine.kept.read(machine.files().front());
  Options with_bot = machine.options();
  with_bot.bot = true;

  CHECK(machine.run("counter", with_bot) == 1);
  CHECK(machine.run("counter", with_bot) == 1);
  CHECK(machine.kept.read(machine.files().front()) == before);
}

TEST_CASE("storage: an embedding host that names no folder gets no files", "[app][storage]") {
  Machine machine;
  CHECK(machine.run("counter", Options{}) == 1);
  CHECK(machine.run("counter", Options{}) == 1);
  CHECK(machine.files().empty());
}

TEST_CASE("storage: a replay sees what its recording began with and saves nothing", "[app][storage]") {
  Machine machine;
  machine.run();
  const std::string recording = (machine.games / "run.json").string();
  std::uint64_t hash = 0;
  {
    Runtime runtime(machine.options());
    runtime.load((machine.games / "counter").string());
    runtime.tick(30);
    hash = runtime.hash();
    runtime.save_recording(recording);
  }
  REQUIRE(machine.run() == 3);
  const std::string before = machine.kept.read(machine.files().front());

  Runtime replay(machine.options());
  replay.play_recording(recording);
  replay.load((machine.games / "counter").string());
  replay.tick(30);

  CHECK(replay.report("runs").number_or(0) == 2);
  CHECK(replay.hash() == hash);
  CHECK(machine.kept.read(machine.files().front()) == before);
}

TEST_CASE("storage: games of like names, titles or authors do not share", "[app][storage]") {
  const std::string name = storage_name("my game", "Heights", "Ada");

  CHECK(name == storage_name("my game", "Heights", "Ada"));
  CHECK(name.starts_with("my_game-"));
  for (const auto& other : {storage_name("my_game", "Heights", "Ada"), storage_name("my game", "Height", "Ada"),
                            storage_name("my game", "Heights", "Bob"), storage_name("my game", "HeightsA", "da")})
    CHECK(name != other);
  // No name leads out of the folder, whatever somebody calls a game.
  for (const char* wild : {"../../etc", "/abs", "..", "a\\b", "C:evil", "ä\n", ""}) {
    const std::string made = storage_name(wild, "", "");
    CHECK(made.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos);
  }
  CHECK(storage_name(std::string(5000, 'x'), "", "").size() < 60);
}

TEST_CASE("storage: a broken file is kept aside, and the game starts with nothing", "[app][storage]") {
  const std::string huge = "{\"tumble_storage\": 1, \"values\": {\"a\": \"" + std::string(20 << 20, 'x') + "\"}}";
  for (const std::string& text : {std::string("{\"tumble_stor"), std::string(), std::string("\0\xff\xfe", 3), std::string("[]"), huge}) {
    Machine machine;
    machine.run();
    machine.put(text);

    CHECK(machine.run() == 1);
    CHECK_THAT(machine.log, Contains("storage: '") && Contains("is not used (") && Contains("it is kept as 'storage.json.broken', and the game begins with nothing stored"));
    CHECK(fs::file_size(machine.file().string() + ".broken") == text.size());
    CHECK(machine.run() == 2);
  }
}

TEST_CASE("storage: a folder in the file's place is moved aside too", "[app][storage]") {
  Machine machine;
  fs::create_directories(machine.file() / "inner");

  CHECK(machine.run() == 1);
  CHECK_THAT(machine.log, Contains("it is no file"));
  CHECK(fs::is_directory(machine.file().string() + ".broken"));
  CHECK(machine.run() == 2);
}

TEST_CASE("storage: where nothing can be written a sentence says so once, and the game goes on", "[app][storage]") {
  Machine machine;
  machine.game("busy", "function update() storage.save(\"tick\", time.tick) end");
  std::ofstream(machine.kept / "wall") << "a file, not a folder";
  Options options = machine.options();
  options.storage = (machine.kept / "wall").string();

  machine.run("busy", options, 60);

  CHECK_THAT(machine.log, Contains("cannot be written (") && Contains("what the game stores is lost when it ends"));
  CHECK(std::count(machine.log.begin(), machine.log.end(), '\n') == 1);
}

TEST_CASE("storage: keys that a player chose are there in the next run, where they still fit", "[app][storage]") {
  Machine machine;
  machine.games.write("keys/game.json", R"({"actions": {"jump": ["space"], "duck": ["s"]}})");
  machine.game("keys", R"(
    function start()
      game.report.jump = table.concat(input.bindings("jump"), " ")
      game.report.duck = table.concat(input.bindings("duck"), " ")
    end
    function on_choose()
      input.bind("jump", { "k", "pad_b" }, { save = true })
      input.bind("duck", { "x" })
    end
    function on_reset() input.reset_bindings() end)");
  const auto keys = [&](const char* message) {
    Runtime runtime(machine.options());
    runtime.load((machine.games / "keys").string());
    runtime.tick();
    if (*message) runtime.send(message);
    runtime.tick();
    CHECK(runtime.script_errors() == 0);
    return runtime.report("jump").string_or("") + ", " + runtime.report("duck").string_or("");
  };

  CHECK(keys("choose") == "space, s");
  CHECK(keys("") == "k pad_b, s");
  CHECK(keys("reset") == "k pad_b, s");
  CHECK(keys("choose") == "space, s");
  machine.games.write("keys/game.json", R"({"actions": {"hop": ["space"], "duck": ["s"], "jump": ["space"]}})");
  CHECK(keys("") == "k pad_b, s");
}
