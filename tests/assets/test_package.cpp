#include "assets/package.h"
#include "assets/game_path.h"

#include "assets/temporary_folder.h"
#include "base/error.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace tumble;
namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

namespace {

// What the author reads; "" when nothing was wrong.
std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string message_of_opening(const fs::path& path) {
  return message_of([&] { Package::open(path); });
}

// Writes zips byte by byte, since real tools refuse to make the bad ones.
struct RawZip {
  struct Entry {
    std::string name, bytes;
    std::uint32_t claimed_size;
    std::uint32_t attributes = 0;
    bool broken_checksum = false;
  };
  std::vector<Entry> entries;

  RawZip& add(const std::string& name, const std::string& bytes) {
    entries.push_back({name, bytes, static_cast<std::uint32_t>(bytes.size())});
    return *this;
  }

  std::string text() const {
    std::string files, directory;
    for (const Entry& entry : entries) {
      const auto start = files.size();
      files += number(0x04034b50, 4) + header(entry) + number(0, 2) + entry.name + entry.bytes;
      directory += number(0x02014b50, 4) + number(3 << 8 | 20, 2) + header(entry) + number(0, 2) + number(0, 2) +
                   number(0, 2) + number(0, 2) + number(entry.attributes, 4) + number(start, 4) + entry.name;
    }
    const std::string count = number(entries.size(), 2);
    return files + directory + number(0x06054b50, 4) + number(0, 4) + count + count + number(directory.size(), 4) +
           number(files.size(), 4) + number(0, 2);
  }

 private:
  static std::string number(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
  }

  static std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const unsigned char byte : bytes) {
      crc ^= byte;
      for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc;
  }

  // Version, UTF-8 flag, stored, time, date, checksum, both sizes, length of the name.
  static std::string header(const Entry& entry) {
    return number(20, 2) + number(1 << 11, 2) + number(0, 2) + number(0, 2) + number(33, 2) +
           number(crc32(entry.bytes) ^ (entry.broken_checksum ? 1u : 0u), 4) + number(entry.bytes.size(), 4) +
           number(entry.claimed_size, 4) + number(entry.name.size(), 2);
  }
};

RawZip zip_with_main() { return RawZip().add("main.lua", "print 'hello'"); }

}  // namespace

TEST_CASE("package: a folder gives its files, sorted, without what is hidden or temporary", "[assets]") {
  TemporaryFolder games;
  games.write("hello/main.lua", "print 'hello'");
  games.write("hello/levels/two.json", "2");
  games.write("hello/levels/one.json", "1");
  games.write("hello/levels-old/one.json", "0");
  games.write("hello/.git/config", "");
  games.write("hello/main.lua~", "");
  games.write("hello/.main.lua.swp", "");
  games.write("hello/hello.tumble", "");

  const auto game = Package::open(games / "hello");

  CHECK(game->name() == "hello");
  CHECK(game->entry() == "main.lua");
  CHECK(game->folder() == games / "hello");
  CHECK(game->list() == Paths{"levels-old/one.json", "levels/one.json", "levels/two.json", "main.lua"});
  CHECK(game->list("levels") == Paths{"levels/one.json", "levels/two.json"});
  CHECK(game->list("levels/") == game->list("levels"));
  CHECK(game->read("levels/two.json") == "2");
  CHECK(game->exists("levels/two.json"));
  CHECK_FALSE(game->exists("levels"));
  CHECK(game->read("levels/three.json") == std::nullopt);
}

TEST_CASE("package: a zip gives what its folder gives, but cannot be watched", "[assets]") {
  TemporaryFolder games;
  games.write("hello.tumble", zip_with_main().add("levels/", "").add("levels/one.json", "1").text());

  const auto game = Package::open(games / "hello.tumble");

  CHECK(game->name() == "hello");
  CHECK(game->entry() == "main.lua");
  CHECK(game->folder() == std::nullopt);
  CHECK(game->list() == Paths{"levels/one.json", "main.lua"});
  CHECK(game->list("levels") == Paths{"levels/one.json"});
  CHECK(game->read("main.lua") == "print 'hello'");
  CHECK(game->read("Main.lua") == std::nullopt);
}

TEST_CASE("package: a zip behind a program is found, whatever the program ends with", "[assets]") {
  TemporaryFolder games;
  games.write("player", "\177ELF code PK\5\6 and more code" + zip_with_main().text());
  games.write("bare", "\177ELF code");

  CHECK(Package::appended_to(games / "player")->read("main.lua") == "print 'hello'");
  CHECK(Package::open(games / "player")->read("main.lua") == "print 'hello'");
  CHECK(Package::appended_to(games / "bare") == nullptr);
}

TEST_CASE("package: a folder that a file manager zipped whole is entered", "[assets]") {
  TemporaryFolder games;
  games.write(
      "hello.zip",
      RawZip().add("hello/main.lua", "1").add("hello/.DS_Store", "x").add("__MACOSX/hello/._main.lua", "x").text());

  const auto game = Package::open(games / "hello.zip");

  CHECK(game->list() == Paths{"main.lua"});
  CHECK(game->read("main.lua") == "1");
}

TEST_CASE("package: a single script is a game in its folder", "[assets]") {
  TemporaryFolder samples;
  samples.write("bounce.lua", "");
  samples.write("ball.png", "");

  const auto game = Package::open(samples / "bounce.lua");

  CHECK(game->name() == "bounce");
  CHECK(game->entry() == "bounce.lua");
  CHECK(game->exists("ball.png"));
}

TEST_CASE("package: a game may have nothing but a game.json, and a slash behind its name", "[assets]") {
  TemporaryFolder games;
  games.write("hello/game.json", "{}");

  CHECK(Package::open(games / "hello/")->entry() == "");
  CHECK(Package::open(games / "hello/")->name() == "hello");
}

TEST_CASE("package: names may have spaces, umlauts and any UTF-8", "[assets]") {
  TemporaryFolder games;
  games.write("Mein schönes Spiel/main.lua", "");
  games.write("Mein schönes Spiel/Bälle/große Kugel 球.txt", "rund");

  const auto game = Package::open(games / "Mein schönes Spiel");

  CHECK(game->name() == "Mein schönes Spiel");
  CHECK(game->list() == Paths{"Bälle/große Kugel 球.txt", "main.lua"});
  CHECK(game->read("Bälle/große Kugel 球.txt") == "rund");
}

TEST_CASE("package: opening says what is missing and what may be meant", "[assets]") {
  TemporaryFolder games;
  games.write("hello/main.lua", "");
  games.write("shout/Main.lua", "");
  games.write("empty/notes.txt", "");
  games.write("picture.png", "not a zip");
  games.write("half.tumble", zip_with_main().text().substr(0, 60));
  games.write("other.zip", RawZip().add("letter.txt", "").text());
  const std::string at = "game '" + games.path().string();

  CHECK(message_of_opening(games / "helo") ==
        at + "/helo': there is no such folder or file; did you mean '" + (games / "hello").string() + "'?");
  CHECK(message_of_opening(games / "zebra") ==
        at + "/zebra': there is no such folder or file; give a game's folder, such as one that `tumble new` makes");
  CHECK(message_of_opening(games / "shout") ==
        at + "/shout': neither main.lua nor game.json is in it; rename 'Main.lua' to 'main.lua'");
  CHECK(message_of_opening(games / "empty") ==
        at + "/empty': neither main.lua nor game.json is in it; a game starts with its main.lua");
  CHECK(message_of_opening(games.path()) ==
        at + "': neither main.lua nor game.json is in it; games are in its folders: half.tumble, hello");
  CHECK(message_of_opening(games / "picture.png") ==
        at + "/picture.png': neither a game's folder, a .lua file nor a package");
  CHECK(message_of_opening(games / "half.tumble") ==
        at + "/half.tumble': the package is broken (its end is missing); fetch or pack it again");
  CHECK(message_of_opening(games / "other.zip") ==
        at + "/other.zip': neither main.lua nor game.json is in the package; zip what is in the folder");
}

TEST_CASE("package: a path that leads out of the game or reads otherwise elsewhere is refused", "[assets]") {
  TemporaryFolder games;
  games.write("secret.txt", "secret");
  games.write("hello/main.lua", "");
  games.write("hello.tumble", zip_with_main().text());

  for (const auto& game : {Package::open(games / "hello"), Package::open(games / "hello.tumble")}) {
    const auto message = [&](const std::string& path) { return message_of([&] { game->read(path); }); };
    CHECK(message("../secret.txt") ==
          "file '../secret.txt': '..' is not allowed; a path starts in the game's folder and stays inside");
    CHECK(message("levels/../../secret.txt") != "");
    CHECK(message("/etc/passwd") == "file '/etc/passwd': a path starts in the game's folder, not at the disk's root");
    CHECK(message("C:/secret.txt") != "");
    CHECK(message("levels\\one.png") ==
          "file 'levels\\one.png': write '/' between folders, not '\\': 'levels/one.png'");
    CHECK(message("./main.lua") == "file './main.lua': leave out '.' and doubled '/': 'main.lua'");
    CHECK(message("") == "file '': a path must not be empty");
    CHECK(message(std::string("main.lua\0.png", 13)) != "");
    CHECK(message("\xff.png") != "");
    CHECK(message(".git/config") ==
          "file '.git/config': hidden files, editors' temporaries and packages are no part of a game; rename it");
    CHECK(message_of([&] { game->exists("../secret.txt"); }) != "");
    CHECK(message_of([&] { game->list(".."); }) != "");
  }
}

TEST_CASE("package: a link may stand for a file of the game, and for nothing else", "[assets]") {
  TemporaryFolder games;
  games.write("secret.txt", "secret");
  games.write("hello/main.lua", "1");
  games.write("hello/levels/one.json", "");
  fs::create_symlink("main.lua", games / "hello/again.lua");
  fs::create_symlink("../secret.txt", games / "hello/out.txt");
  fs::create_directory_symlink("..", games / "hello/up");
  fs::create_directory_symlink("levels", games / "hello/stages");

  const auto game = Package::open(games / "hello");
  const auto message = [&](const std::string& path) { return message_of([&] { game->read(path); }); };

  CHECK(game->read("again.lua") == "1");
  CHECK(message("out.txt") == "file 'out.txt': a link that leads out of the game 'hello'; copy the file into the game");
  CHECK(message("up/secret.txt") ==
        "file 'up/secret.txt': a link that leads out of the game 'hello'; copy the file into the game");
  CHECK(message("stages/one.json") == "file 'stages/one.json': 'stages' is a link; copy the folder instead");
}

TEST_CASE("package: a file too large for a game is refused before it is read", "[assets]") {
  TemporaryFolder games;
  games.write("hello/main.lua", "");
  games.write("hello/film.raw", "");
  fs::resize_file(games / "hello/film.raw", kMaxFileBytes + (1 << 20));  // takes no room on the disk

  const auto game = Package::open(games / "hello");

  CHECK(message_of([&] { game->read("film.raw"); }) ==
        "file 'film.raw': too large (257 MB); a game's file may have 256 MB");
}

TEST_CASE("package: a hostile zip is refused with a reason", "[assets]") {
  TemporaryFolder games;
  const std::string at = "game '" + (games / "bad.tumble").string() + "': ";
  const auto message = [&](const RawZip& zip) {
    games.write("bad.tumble", zip.text());
    return message_of_opening(games / "bad.tumble");
  };

  CHECK(message(zip_with_main().add("../evil.lua", "")) ==
        at + "refused: file '../evil.lua': '..' is not allowed; a path starts in the game's folder and stays inside");
  CHECK(message(zip_with_main().add("/etc/passwd", "")) ==
        at + "refused: file '/etc/passwd': a path starts in the game's folder, not at the disk's root");
  CHECK(message(zip_with_main().add("a\\b", "")) ==
        at + "refused: file 'a\\b': write '/' between folders, not '\\': 'a/b'");
  CHECK(message(zip_with_main().add("main.lua", "again")) == at + "refused, since it holds 'main.lua' twice");

  RawZip link = zip_with_main().add("out.txt", "/etc/passwd");
  link.entries.back().attributes = 0120777u << 16;
  CHECK(message(link) == at + "refused, since 'out.txt' is a link; pack the game's folder with `tumble pack`");

  RawZip huge = zip_with_main().add("huge.bin", "");
  huge.entries.back().claimed_size = 0x7fffffff;
  CHECK(message(huge) == at + "refused: file 'huge.bin': too large (2047 MB); a game's file may have 256 MB");

  RawZip bomb = zip_with_main();
  for (int i = 0; i < 9; ++i) {
    bomb.add("part" + std::to_string(i), "");
    bomb.entries.back().claimed_size = 0x0fffffff;
  }
  CHECK(message(bomb) == at + "refused, since it would unpack to more than 2048 MB");

  RawZip crowd = zip_with_main();
  for (int i = 0; i < 65534; ++i) crowd.add(std::to_string(i), "");
  CHECK(message(crowd) == at + "refused, since it holds more than 65534 files or 4 GB");
}

TEST_CASE("package: a damaged file in a zip is named when it is read", "[assets]") {
  TemporaryFolder games;
  RawZip zip = zip_with_main().add("ball.txt", "round").add("long.txt", "four");
  zip.entries[1].broken_checksum = true;
  zip.entries[2].claimed_size = 400;
  games.write("hello.tumble", zip.text());
  const std::string at = "game '" + (games / "hello.tumble").string() + "': ";

  const auto game = Package::open(games / "hello.tumble");

  CHECK(game->read("main.lua") == "print 'hello'");
  CHECK(message_of([&] { game->read("ball.txt"); }) ==
        at + "'ball.txt' is damaged (CRC error); fetch or pack the game again");
  CHECK(message_of([&] { game->read("long.txt"); }) != "");
}

TEST_CASE("package: no cut or changed byte of a zip does worse than a worded error", "[assets]") {
  TemporaryFolder games;
  const std::string whole = zip_with_main().add("levels/one.json", "1").text();
  const auto open_and_read = [&](const std::string& bytes) {
    games.write("bad.tumble", bytes);
    message_of([&] {
      const auto game = Package::open(games / "bad.tumble");
      for (const std::string& path : game->list()) game->read(path);
    });
  };

  for (std::size_t length = 0; length < whole.size(); ++length) open_and_read(whole.substr(0, length));
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const int bits : {0x01, 0x80, 0xff}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ bits);
      open_and_read(changed);
    }

  SUCCEED("nothing but tumble::Error was thrown");
}
