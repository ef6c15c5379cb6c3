#include "assets/watch.h"

#include "assets/temporary_folder.h"
#include "base/error.h"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace tumble;
namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

namespace {

// A game's folder with one script and one level.
struct WatchedGame {
  TemporaryFolder folder;
  WatchedGame() {
    folder.write("main.lua", "1");
    folder.write("levels/one.json", "1");
  }
};

}  // namespace

TEST_CASE("watch: nothing is reported until something changes", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  CHECK(watch.poll() == Paths{});
  CHECK(watch.warning() == "");
}

TEST_CASE("watch: written, made and removed files are reported once, sorted", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  game.folder.write("main.lua", "2");
  game.folder.write("main.lua", "3");
  game.folder.write("levels/two.json", "2");
  fs::remove(game.folder / "levels/one.json");

  CHECK(watch.poll() == Paths{"levels/one.json", "levels/two.json", "main.lua"});
  CHECK(watch.poll() == Paths{});
}

TEST_CASE("watch: a file is not reported while it is being written", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());
  std::ofstream file(game.folder / "main.lua");

  file << "half" << std::flush;
  CHECK(watch.poll() == Paths{});
  file << " and whole";
  file.close();

  CHECK(watch.poll() == Paths{"main.lua"});
}

TEST_CASE("watch: saves by renaming are caught, again and again, and leave no temporaries", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  for (int i = 0; i < 50; ++i) {
    game.folder.write("main.lua.Xy7" + std::to_string(i), "new");
    fs::rename(game.folder / ("main.lua.Xy7" + std::to_string(i)), game.folder / "main.lua");
    REQUIRE(watch.poll() == Paths{"main.lua"});
  }
}

TEST_CASE("watch: Vim's way of saving is one change", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  game.folder.write("4913", "");
  fs::remove(game.folder / "4913");
  game.folder.write(".main.lua.swp", "");
  fs::rename(game.folder / "main.lua", game.folder / "main.lua~");
  game.folder.write("main.lua", "2");
  fs::remove(game.folder / "main.lua~");

  CHECK(watch.poll() == Paths{"main.lua"});
}

TEST_CASE("watch: hidden folders and editors' temporaries are not reported", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  for (const char* name :
       {".git/index", ".#main.lua", "#main.lua#", "main.lua~", ".main.lua.swp", "x.tmp", "hello.tumble"})
    game.folder.write(name, "x");

  CHECK(watch.poll() == Paths{});
}

TEST_CASE("watch: new folders are watched with all that is in them", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  game.folder.write("sounds/steps/left.wav", "1");
  CHECK(watch.poll() == Paths{"sounds/steps/left.wav"});
  game.folder.write("sounds/steps/left.wav", "2");
  game.folder.write("sounds/steps/right.wav", "2");
  CHECK(watch.poll() == Paths{"sounds/steps/left.wav", "sounds/steps/right.wav"});
}

TEST_CASE("watch: a folder may be removed and made again, also between two polls", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  fs::remove_all(game.folder / "levels");
  CHECK(watch.poll() == Paths{"levels/one.json"});

  game.folder.write("levels/one.json", "2");
  fs::remove_all(game.folder / "levels");
  game.folder.write("levels/two.json", "2");
  CHECK(watch.poll() == Paths{"levels/two.json"});

  game.folder.write("levels/two.json", "3");
  CHECK(watch.poll() == Paths{"levels/two.json"});
}

TEST_CASE("watch: a renamed folder is its files under the old and the new name", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  fs::rename(game.folder / "levels", game.folder / "stages");
  CHECK(watch.poll() == Paths{"levels/one.json", "stages/one.json"});
  game.folder.write("stages/one.json", "2");
  CHECK(watch.poll() == Paths{"stages/one.json"});
}

TEST_CASE("watch: the game's folder itself may vanish and come back", "[assets]") {
  TemporaryFolder games;
  games.write("hello/main.lua", "1");
  Watch watch(games / "hello");

  SECTION("removed") { fs::remove_all(games / "hello"); }
  SECTION("renamed") { fs::rename(games / "hello", games / "elsewhere"); }
  CHECK(watch.poll() == Paths{"main.lua"});
  CHECK(watch.poll() == Paths{});

  games.write("hello/main.lua", "2");
  CHECK(watch.poll() == Paths{"main.lua"});
  games.write("hello/main.lua", "3");
  CHECK(watch.poll() == Paths{"main.lua"});
}

TEST_CASE("watch: links count as files when they are made", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  fs::create_symlink("main.lua", game.folder / "soft.lua");
  fs::create_hard_link(game.folder / "main.lua", game.folder / "hard.lua");

  CHECK(watch.poll() == Paths{"hard.lua", "soft.lua"});
}

TEST_CASE("watch: after more events than the system keeps, everything that changed is still found", "[assets]") {
  WatchedGame game;
  Watch watch(game.folder.path());

  // Two events for each round; the system keeps 16384 unless told otherwise.
  for (int i = 0; i < 20000; ++i)
    close(open((game.folder / ("noise" + std::to_string(i % 2))).c_str(), O_CREAT | O_WRONLY, 0644));
  fs::remove(game.folder / "noise0");
  fs::remove(game.folder / "noise1");
  game.folder.write("main.lua", "longer");
  game.folder.write("late/two.lua", "2");
  CHECK(watch.poll() == Paths{"late/two.lua", "main.lua"});

  game.folder.write("late/two.lua", "3");
  CHECK(watch.poll() == Paths{"late/two.lua"});
}

TEST_CASE("watch: where the system offers no watches, changes are found by comparing, with a warning", "[assets]") {
  WatchedGame game;
  // No file descriptor is left for inotify while the watch is made.
  rlimit before;
  getrlimit(RLIMIT_NOFILE, &before);
  rlimit none = before;
  none.rlim_cur = static_cast<rlim_t>(dup(0));
  close(static_cast<int>(none.rlim_cur));
  setrlimit(RLIMIT_NOFILE, &none);
  Watch watch(game.folder.path());
  setrlimit(RLIMIT_NOFILE, &before);
  const auto next_poll = [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(260));
    return watch.poll();
  };

  CHECK(watch.warning() ==
        "watch: looking for changed files 4 times a second instead of at once, "
        "since too many programs or files are open; close some, or raise fs.inotify.max_user_instances");
  watch.poll();
  game.folder.write("main.lua", "longer");
  game.folder.write("sounds/step.wav", "1");
  fs::remove(game.folder / "levels/one.json");
  CHECK(watch.poll() == Paths{});
  CHECK(next_poll() == Paths{"levels/one.json", "main.lua", "sounds/step.wav"});
  CHECK(next_poll() == Paths{});
}

TEST_CASE("watch: a folder that does not exist is the caller's mistake", "[assets]") {
  CHECK_THROWS_WITH(Watch("/no/such/folder"), "watch: there is no folder '/no/such/folder' to watch");
}
