// new: the smallest game that runs, with a bot and a test.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/program.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

const char* const kMain = R"(-- Save this file while the game runs, and see the change at once.
scene.add { name = "floor", position = vec3(0, -0.5, 0), color = "seagreen", mesh = { shape = "box", size = vec3(10, 1, 10) }, body = "static" }

local ball = scene.add { name = "ball", position = vec3(0, 3, 0), color = "orange", mesh = "sphere", body = { restitution = 0.6 } }

function on_press(name)
  if name == "kick" then ball.body:apply_impulse(vec3(0, 5, 0)) end
end

function draw_ui()
  ui.text("space kicks the ball", { at = "top" })
end
)";

const char* const kBot = R"(-- Plays the game with --bot, through the same input that a person uses.
return function()
  while true do
    wait(2)
    tap("kick")
  end
end
)";

const char* const kTest = R"(-- Each test runs in a fresh game.
test("the ball comes to rest on the floor", function()
  wait(5)
  expect(scene.get("ball").position.y):near(0.5, 0.01)
end)

test("a kick lifts the ball", function()
  wait(5)
  tap("kick")
  wait(0.2)
  expect(scene.get("ball").position.y):above(1)
end)
)";

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return result + "\"";
}

// As it is called from here.
const char* program() { return fs::is_regular_file("tumble") ? "./tumble" : "tumble"; }

void check_name(const fs::path& folder, const std::string& name) {
  const auto bad = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  if (name.empty() || name.front() == '.' || name.front() == '-' || std::any_of(name.begin(), name.end(), bad))
    throw Error("new: '" + name + "' cannot be a game's name; begin it with a letter, such as mygame");
  if (fs::exists(fs::symlink_status(folder))) throw Error("new: '" + folder.string() + "' exists already; give another name, or play it: " + program() + " play " + shell_word(folder.string()));
  if (folder.has_parent_path() && !fs::is_directory(folder.parent_path()))
    throw Error("new: there is no folder '" + folder.parent_path().string() + "'; make it first");
}

int make_game(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  const fs::path folder = path;
  const std::string name = folder.filename().string();
  check_name(folder, name);
  std::error_code error;
  fs::create_directories(folder / "tests", error);
  if (error) throw Error("new: the folder '" + folder.string() + "' cannot be made (" + error.message() + ")");
  write_file(folder / "game.json", "{\n  \"title\": " + quoted(name) + ",\n  \"actions\": { \"kick\": [\"space\", \"pad_a\"] }\n}\n", "new");
  write_file(folder / "main.lua", kMain, "new");
  write_file(folder / "bot.lua", kBot, "new");
  write_file(folder / "tests" / "first.lua", kTest, "new");
  const std::string word = name.find_first_of(" '\"$&()*;<>?[]\\`{|}~!#") == std::string::npos ? path : shell_word(path);
  std::cout << "A new game is in '" << path << "'. Play it, and edit " << (folder / "main.lua").string() << " meanwhile:\n\n  " << program() << " play " << word << '\n';
  return 0;
}

}  // namespace

void add_new(CLI::App& app, int& status) {
  auto name = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("new", "Make an empty game that runs");
  verb->add_option("name", *name, "Its folder, which must not be there yet")->required()->type_name("NAME");
  verb->callback([name, &status] { status = make_game(*name); });
}

}  // namespace tumble::cli
