// ui.* in a living game: what survives a save, what a recording gives again, what a call costs.
#include <catch2/catch.hpp>

#include "base/color.h"
#include "engine/ui/ui.h"
#include "support/test_game.h"

using namespace tumble;

namespace {

InputEvent move_to(double x, double y) {
  InputEvent event;
  event.kind = InputKind::pointer_move;
  event.x = x;
  event.y = y;
  return event;
}

const std::string kMenu = R"(
local volume, presses = 0.5, 0
function draw_ui()
  ui.panel({ at = "center", width = 400 }, function()
    volume = ui.slider("Volume", volume)
    if ui.button("Play") then presses = presses + 1 end
  end)
  game.report.volume, game.report.presses = volume, presses
end
)";

}  // namespace

TEST_CASE("ui: focus and values survive a save", "[ui]") {
  TestGame game(Files{{"main.lua", kMenu}});
  game.tick(2);
  game.tick(1, {press("down")});
  game.tick(1, {release("down")});
  REQUIRE(game.script->ui().focused() == "Play");

  game.save("main.lua", kMenu + "-- a remark\n");
  game.tick(1);

  CHECK(game.script->ui().focused() == "Play");
  game.tick(1, {press("enter")});
  CHECK(game.number("presses") == 1);
}

TEST_CASE("ui: a style at the top level is taken at a save, and drawn", "[ui]") {
  const std::string text = "ui.style { panel = \"#102030\" }\n" + kMenu;
  TestGame game(Files{{"main.lua", text}});
  game.tick(1);
  CHECK(game.script->tick_drawing().ui.at(0).panel.color == *parse_color("#102030"));

  std::string changed = text;
  changed.replace(changed.find("#102030"), 7, "#405060");
  const std::string line = game.save("main.lua", changed);
  game.tick(1);

  CHECK(line.find("ui.panel") != std::string::npos);
  CHECK(game.script->tick_drawing().ui.at(0).panel.color == *parse_color("#405060"));
}

TEST_CASE("ui: the same input gives the same, tick by tick", "[ui]") {
  const std::vector<std::vector<InputEvent>> input = {{}, {press("down")}, {}, {release("down"), press("enter")}, {release("enter")}, {press("up")},
      {release("up"), press("right")}, {}, {release("right")}, {move_to(640, 340), press("pointer")}, {move_to(700, 340)}, {release("pointer")}};
  const auto run = [&] {
    TestGame game(Files{{"main.lua", kMenu}});
    std::vector<double> seen;
    for (const auto& events : input) {
      game.tick(1, events);
      seen.push_back(game.number("volume"));
      seen.push_back(game.number("presses"));
    }
    return seen;
  };
  const auto first = run();
  CHECK(first == run());
  CHECK(first.back() == 1);
}

TEST_CASE("ui: a slider's pointer sets the part of its track that it is at", "[ui]") {
  TestGame game(Files{{"main.lua", kMenu}});
  game.tick(1);
  // The track's ends, as they are drawn: its ground is as wide as the track.
  UiRect track;
  for (const DrawUi& entry : game.script->tick_drawing().ui)
    if (!entry.is_text && entry.panel.height == 8 && track.width == 0) track = {entry.panel.x, entry.panel.y, entry.panel.width, 8};
  REQUIRE(track.width > 50);
  for (const double part : {0.25, 0.5, 0.9}) {
    game.tick(1, {move_to(track.x + part * track.width, track.y + 4), press("pointer")});
    CHECK(game.number("volume") == Approx(part).margin(1e-6));   // places are floats
    game.tick(1, {release("pointer")});
  }
}

TEST_CASE("ui: kept options and words cost no Lua memory", "[ui]") {
  TestGame game(Files{{"main.lua", R"(
    local place, wide = { at = "top_left", size = 30, color = color "gold" }, { at = "bottom", width = 400 }
    function draw_ui()
      for _ = 1, 1000 do
        ui.text("Score", place)
        ui.bar(0.5, wide)
      end
    end
  )"}});
  game.tick(3);
  const std::size_t before = game.script->memory_used();
  game.script->draw_ui();
  // A table of each of the 2000 calls would be more than a hundred thousand bytes.
  CHECK(game.script->memory_used() <= before + 1000);
}
