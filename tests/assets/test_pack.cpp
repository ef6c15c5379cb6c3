#include "assets/pack.h"

#include "assets/package.h"
#include "assets/temporary_folder.h"
#include "base/error.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace tumble;
namespace fs = std::filesystem;

namespace {

std::string message_of_packing(const fs::path& folder, const fs::path& output,
                               std::optional<fs::path> executable = {}) {
  try {
    write_package(folder, output, executable);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  return names;
}

void write_game(const TemporaryFolder& games) {
  games.write("hello/main.lua", "print 'hello'");
  games.write("hello/Bälle/große Kugel.txt", std::string(10000, 'o'));
  games.write("hello/.git/config", "");
  games.write("hello/main.lua~", "");
  games.write("hello/old.tumble", "");
}

}  // namespace

TEST_CASE("pack: a package reads like its folder", "[assets]") {
  TemporaryFolder games;
  write_game(games);

  const PackedGame packed = write_package(games / "hello", games / "out.tumble");

  const auto folder = Package::open(games / "hello"), package = Package::open(games / "out.tumble");
  CHECK(packed.files == 2);
  CHECK(packed.bytes == fs::file_size(games / "out.tumble"));
  CHECK(package->list() == folder->list());
  for (const std::string& path : folder->list()) CHECK(package->read(path) == folder->read(path));
}

TEST_CASE("pack: behind a program it stays a program, and is not packed twice", "[assets]") {
  TemporaryFolder games;
  write_game(games);
  games.write("player", "#!/bin/sh\nexit 7\n");

  write_package(games / "hello", games / "first", games / "player");
  write_package(games / "hello", games / "second", games / "first");

  CHECK(Package::appended_to(games / "first")->read("main.lua") == "print 'hello'");
  CHECK(games.read("first").starts_with("#!/bin/sh\nexit 7\nPK"));
  CHECK(games.read("first") == games.read("second"));
  CHECK((fs::status(games / "first").permissions() & fs::perms::owner_exec) != fs::perms::none);
}

TEST_CASE("pack: the same files give the same bytes, whatever their age and place", "[assets]") {
  TemporaryFolder games, others;
  write_game(games);
  write_game(others);
  fs::last_write_time(others / "hello/main.lua", fs::file_time_type::clock::now() - std::chrono::hours(10000));

  write_package(games / "hello", games / "out.tumble");
  write_package(others / "hello", others / "out.tumble");

  CHECK(games.read("out.tumble") == others.read("out.tumble"));
}

TEST_CASE("pack: a packed program left in the game's folder is not packed into the next one", "[assets]") {
  TemporaryFolder games;
  write_game(games);
  games.write("player", "\177ELF code");
  games.write("hello/tool", "\177ELF without a game");

  write_package(games / "hello", games / "hello/hello", games / "player");
  write_package(games / "hello", games / "hello/hello", games / "player");

  CHECK(Package::open(games / "hello/hello")->list() ==
        std::vector<std::string>{"Bälle/große Kugel.txt", "main.lua", "tool"});
}

TEST_CASE("pack: nothing but an earlier package is overwritten", "[assets]") {
  TemporaryFolder games;
  write_game(games);
  games.write("notes.txt", "mine");
  games.write("player", "\177ELF code");
  const auto at = [&](const std::string& name) { return "'" + (games / name).string() + "'"; };

  CHECK(message_of_packing(games / "hello", games / "notes.txt") ==
        "pack: " + at("notes.txt") + " exists and is no package; give another name or remove it");
  CHECK(message_of_packing(games / "hello", games / "hello/main.lua") ==
        "pack: " + at("hello/main.lua") + " exists and is no package; give another name or remove it");
  CHECK(message_of_packing(games / "hello", games / "hello") ==
        "pack: the output " + at("hello") + " is a folder; give a file name in it");
  CHECK(message_of_packing(games / "hello", games / "player", games / "player") ==
        "pack: the output " + at("player") + " is the program itself; give another name");
  CHECK(message_of_packing(games / "hello", games / "nowhere/out.tumble") ==
        "pack: there is no folder " + at("nowhere") + " for 'out.tumble'; make it first");
  CHECK(message_of_packing(games / "hello", games / "out", games / "plyer") ==
        "pack: there is no program " + at("plyer") + " to pack the game behind");
  CHECK(games.read("notes.txt") == "mine");
  CHECK(names_in(games.path()).size() == 3);

  write_package(games / "hello", games / "out.tumble");
  CHECK(message_of_packing(games / "hello", games / "out.tumble") == "");
}

TEST_CASE("pack: what cannot be in a package stops the packing and leaves the earlier one", "[assets]") {
  TemporaryFolder games;
  write_game(games);
  write_package(games / "hello", games / "out.tumble");
  const std::string earlier = games.read("out.tumble");
  games.write("secret.txt", "");
  fs::create_symlink("../secret.txt", games / "hello/out.txt");

  CHECK(message_of_packing(games / "hello", games / "out.tumble") ==
        "file 'out.txt': a link that leads out of the game 'hello'; copy the file into the game");

  fs::remove(games / "hello/out.txt");
  games.write("hello/a\\b", "");
  CHECK(message_of_packing(games / "hello", games / "out.tumble") ==
        "file 'a\\b': write '/' between folders, not '\\': 'a/b'");
  CHECK(games.read("out.tumble") == earlier);
  CHECK(names_in(games.path()).size() == 3);
}

TEST_CASE("pack: only a folder with a game can be packed", "[assets]") {
  TemporaryFolder games;
  games.write("sample.lua", "");
  games.write("empty/notes.txt", "");

  CHECK(message_of_packing(games / "empty", games / "out.tumble") ==
        "game '" + (games / "empty").string() +
            "': neither main.lua nor game.json is in it; a game starts with its main.lua");
  CHECK(message_of_packing(games / "sample.lua", games / "out.tumble") ==
        "pack: '" + (games / "sample.lua").string() +
            "' is a single file; put it into a folder of its own as main.lua, and pack that");
}
