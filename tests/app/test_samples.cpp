// Every sample runs, and every prefab of every game.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "assets/temporary_folder.h"
#include "base/shape.h"
#include "physics/joint.h"
#include "support/source_tree.h"
#include "tumble/tumble.h"

using namespace tumble;
namespace fs = std::filesystem;

namespace {

// Ticks a game that nobody plays; what went wrong, or "".
std::string faults_of(const fs::path& game, int ticks) {
  std::string faults;
  Runtime runtime;
  runtime.on_log([&](LogLevel level, const std::string& text) {
    if (level >= LogLevel::warning) faults += text + "\n";
  });
  runtime.on_script_error([&](const ScriptError& error) { faults += error.text + "\n"; });
  runtime.load(game.string());
  runtime.tick(ticks);
  return faults;
}

std::vector<fs::path> files_below(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().string().ends_with(ending)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Is there a sample of that name, and does it say so?
bool sample_has(const std::string& name, const std::string& text) {
  const fs::path file = source_tree("games/samples/" + name + ".lua");
  return fs::exists(file) && read_source(file).find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("samples: each runs for five seconds without a fault, is short, and begins with what it is about", "[samples]") {
  const fs::path folder = source_tree("games/samples");
  int samples = 0;
  for (const fs::path& file : files_below(folder, ".lua")) {
    INFO(file.string());
    CHECK(faults_of(file == folder / "main.lua" ? folder : file, 300) == "");
    if (file == folder / "main.lua") continue;
    ++samples;
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    CHECK(line.starts_with("-- "));
    int lines = 1;
    while (std::getline(in, line)) ++lines;
    CHECK(lines <= 60);
  }
  CHECK(samples >= 25);
}

TEST_CASE("samples: every collider shape and every joint has one that bears its name", "[samples]") {
  for (const std::string& shape : enum_names(ShapeKind{})) {
    INFO("games/samples/colliders/" << shape << ".lua");
    CHECK(sample_has("colliders/" + shape, "shape = \"" + shape + "\""));
  }
  for (const std::string& kind : joint_kind_names()) {
    INFO("games/samples/joints/" << kind << ".lua");
    CHECK(sample_has("joints/" + kind, "joint." + kind + " {"));
  }
}

TEST_CASE("samples: every prefab of every game stands alone", "[samples]") {
  int prefabs = 0;
  for (const auto& game : fs::directory_iterator(source_tree("games"))) {
    for (const fs::path& file : files_below(game.path(), ".json")) {
      if (file.parent_path().filename() != "prefabs") continue;
      INFO(file.string());
      // Its files lie beside it as in the game; main.lua does nothing but place it over a floor.
      const fs::path top = file.parent_path().parent_path();
      TemporaryFolder folder;
      fs::copy(top, folder.path(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
      folder.write("main.lua", "scene.add { position = vec3(0, -0.5, 0), mesh = { shape = 'box', size = vec3(20, 1, 20) }, body = 'static' }\n"
                               "scene.add { prefab = 'prefabs/" + file.stem().string() + "', position = vec3(0, 2, 0) }\n");
      CHECK(faults_of(folder.path(), 120) == "");
      ++prefabs;
    }
  }
  CHECK(prefabs >= 5);
}

TEST_CASE("games: one opens another in its folder, and gets it back", "[samples]") {
  TemporaryFolder folder;
  folder.write("main.lua", "scene.add { name = 'menu' }\n"
                           "local list = game.list()\n"
                           "for i, entry in ipairs(list) do game.report[entry.path] = entry.about end\n"
                           "function on_press(name) if name == 'a' then game.open('one/ball.lua') elseif name == 'b' then game.open('two') end end\n");
  folder.write("one/ball.lua", "-- A ball,\n-- alone.\n\nscene.add { name = 'ball' }\nfunction on_press() game.quit() end\n");
  folder.write("two/main.lua", "scene.add { name = 'second' }\n");
  folder.write("two/part.lua", "return behaviour {}\n");
  Runtime runtime;
  std::vector<std::string> errors;
  runtime.on_script_error([&](const ScriptError& error) { errors.push_back(error.text); });
  runtime.load(folder.path().string());
  runtime.tick(1);
  CHECK(runtime.report("one/ball.lua").string_or("") == "A ball, alone.");
  CHECK(runtime.report("two").string_or("-") == "");
  CHECK(runtime.report("two/part.lua").is_nil());

  runtime.press("a");
  runtime.tick(1);
  CHECK(runtime.find("ball"));
  CHECK_FALSE(runtime.find("menu"));
  runtime.press("x");
  runtime.tick(1);           // game.quit() leads back
  CHECK(runtime.find("menu"));
  CHECK_FALSE(runtime.wants_quit());
  runtime.press("b");
  runtime.tick(1);
  CHECK(runtime.find("second"));
  CHECK(errors.empty());
}

TEST_CASE("games: opening what is not there is refused with the nearest", "[samples]") {
  TemporaryFolder folder;
  folder.write("main.lua", "function update() game.open('one/bal.lua') end\n");
  folder.write("one/ball.lua", "");
  CHECK(faults_of(folder.path(), 1).find("game.open: no game 'one/bal.lua' in this folder; did you mean 'one/ball.lua'?") != std::string::npos);
}
