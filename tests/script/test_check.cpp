#include <catch2/catch.hpp>

#include <filesystem>

#include "script/check.h"
#include "script/check_lexer.h"
#include "support/source_tree.h"
#include "support/test_game.h"

using namespace tumble;

namespace {

CheckedGame game_of(const Files& files) {
  CheckedGame game;
  game.read = [files](const std::string& path) -> std::optional<std::string> {
    const auto found = files.find(path);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  for (const auto& [path, text] : files) game.files.push_back(path);
  return game;
}

std::string found_in(const CheckedGame& game, bool warnings = true) {
  std::string text;
  for (const CheckFinding& finding : check_game(game))
    if (finding.is_error || warnings) text += finding.file + ":" + std::to_string(finding.line) + " " + finding.text + "\n";
  return text;
}

CheckedGame game_in(const std::filesystem::path& folder) {
  CheckedGame game;
  game.read = [folder](const std::string& path) -> std::optional<std::string> {
    if (!std::filesystem::exists(folder / path)) return std::nullopt;
    return read_source(folder / path);
  };
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) game.files.push_back(entry.path().lexically_relative(folder).generic_string());
  std::sort(game.files.begin(), game.files.end());
  return game;
}

}  // namespace

TEST_CASE("check: words, texts and lines of Lua are told apart", "[script][check]") {
  const std::vector<Token> t = lua_tokens("#!first\nlocal a = 0x1p-3 -- no\n--[==[ long\n]] ]==] b.c:d [[\nx\\n]] 'q\\'r' 1..2 ..3");
  std::string text;
  for (const Token& token : t)
    if (token.kind != Token::Kind::end) text += std::to_string(token.line) + (token.is_text() ? "'" : token.is_name() ? "n" : "s") + token.text + "|";
  CHECK(text == "2slocal|2na|2s=|2s0x1p-3|4nb|4s.|4nc|4s:|4nd|4'\nx\\n|5'q\\'r|5s1|5s..|5s2|5s..|5s3|");
}

TEST_CASE("check: our games are without a fault", "[script][check]") {
  for (const char* name : {"basketball", "platformer", "hello"}) {
    INFO(name);
    CHECK(found_in(game_in(source_tree("games") / name), false) == "");
  }
}

TEST_CASE("check: what is put together from parts counts as used", "[script][check]") {
  const std::string scene = R"({ "tumble": 1, "name": "n", "children": [{ "name": "coin 3" }] })";
  CHECK(found_in(game_of({{"main.lua", "local n = 1\nfunction start()\n  scene.load('levels/' .. n)\n  scene.get('coin ' .. n).color = 'red'\nend\n"}, {"levels/1.json", scene}})) == "");
}

TEST_CASE("check: a name that another file of the game defines is known", "[script][check]") {
  CHECK(found_in(game_of({{"main.lua", "local court = require 'court'\nfunction start() print(court.width, court:area()) end\n"},
                          {"court.lua", "local court = { width = 3 }\nfunction court:area() return self.width * 2 end\nreturn court\n"}})) == "");
}

TEST_CASE("check: a name that nobody defines is told with the nearest", "[script][check]") {
  CHECK(found_in(game_of({{"main.lua", "local court = require 'court'\nfunction start() print(court.widht) end\n"}, {"court.lua", "return { width = 3 }\n"}})) ==
        "main.lua:2 '.widht': neither the engine nor this game has a 'widht'; did you mean 'width'?\n");
}

TEST_CASE("check: what tables of the engine hold is known, and one file of a folder has nothing to do with the others", "[script][check]") {
  CheckedGame game = game_of({{"one.lua", "function update() print(physics.stats().awake, physics.stats().substeps, game.list()[1].about) end\n"}, {"two.lua", "print(1)\n"}});
  game.entry = "one.lua";
  CHECK(found_in(game) == "");
}

TEST_CASE("check: a broken text or file is told and the rest is still looked at", "[script][check]") {
  const std::string found = found_in(game_of({{"main.lua", "local x = = 3\nprint(phyics)\n"}, {"one.json", "{ \"tumble\": 1, "}}));
  CHECK(found.find("main.lua:1 unexpected symbol near '='") != std::string::npos);
  CHECK(found.find("main.lua:2 unknown name 'phyics'; did you mean 'physics'?") != std::string::npos);
  CHECK(found.find("one.json:1") != std::string::npos);
}

TEST_CASE("check: any bytes are looked at without harm", "[script][check]") {
  std::string text = read_source(source_tree("games/platformer/main.lua"));
  std::uint32_t state = 1;
  for (int i = 0; i < 300; ++i) {
    state = state * 1664525 + 1013904223;
    std::string broken = text;
    broken[state % broken.size()] = static_cast<char>(state >> 24);
    broken.resize((state >> 8) % broken.size());
    CHECK_NOTHROW(check_game(game_of({{"main.lua", broken}})));
  }
}

TEST_CASE("check: luacheck is told of every module", "[script][check]") {
  const std::string config = check_config();
  for (const char* word : {"scene = { fields = {", " raycast = {", " vec3", "behaviour", "\"wait_until\""}) CHECK(config.find(word) != std::string::npos);
}
