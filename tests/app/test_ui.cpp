// Menus through the embedding interface: as a host, a bot and a recording use them.
#include <catch2/catch.hpp>

#include "assets/temporary_folder.h"
#include "tumble/tumble.h"

using namespace tumble;

namespace {

const std::string kMenu = R"(
local presses, volume, heard = 0, 0.5, 0
function on_press() heard = heard + 1 end
function draw_ui()
  ui.panel({ at = "bottom_right", width = 400 }, function()
    volume = ui.slider("Volume", volume)
    if ui.button("Play") then presses = presses + 1 end
  end)
  game.report.presses, game.report.volume, game.report.heard = presses, volume, heard
end
)";

const std::string kBot = R"(
return function()
  click("Play")
  tap("up")
  wait(0.1)
  press("right")
  wait(1)
  release("right")
  click("Play")
end
)";

struct Folder {
  TemporaryFolder folder;
  Folder() {
    folder.write("main.lua", kMenu);
    folder.write("bot.lua", kBot);
  }
  std::string path() const { return folder.path().string(); }
};

}  // namespace

TEST_CASE("ui: what a bot clicked is recorded, and a replay gives the same", "[ui]") {
  Folder game;
  const std::string file = (game.folder / "input").string();
  Options options;
  options.bot = true;
  Runtime played(options);
  played.load(game.path());
  played.tick(150);
  played.save_recording(file);
  REQUIRE(played.report("presses").number_or(0) == 2);
  REQUIRE(played.report("volume").number_or(0) > 0.7);
  CHECK(played.report("heard").number_or(-1) == 0);   // the widgets took everything

  Runtime replayed;
  replayed.play_recording(file);
  replayed.load(game.path());
  replayed.tick(150);

  CHECK(replayed.hash() == played.hash());
  CHECK(replayed.report("volume").number_or(0) == played.report("volume").number_or(1));
}

TEST_CASE("ui: a host presses a button where it stands", "[ui]") {
  Folder game;
  Runtime runtime;
  runtime.load(game.path());
  runtime.tick(1);
  // Right of the middle of the panel's lower widget: margin 24, padding 24.
  const Runtime::Place place{1280 - 24 - 100, 720 - 24 - 24 - 10};
  runtime.press("pointer", place);
  runtime.tick(1);
  CHECK(runtime.report("presses").number_or(-1) == 0);
  runtime.release("pointer");
  runtime.tick(1);
  CHECK(runtime.report("presses").number_or(-1) == 1);
}
