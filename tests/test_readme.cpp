// The README's game is one that runs, and the one in games/hello.
#include <catch2/catch.hpp>

#include "support/source_tree.h"
#include "support/test_game.h"

namespace {

// What stands between the first ```lua and the next ```.
std::string first_game(const std::string& readme) {
  const std::size_t begin = readme.find("```lua\n") + 7;
  return readme.substr(begin, readme.find("```", begin) - begin);
}

}  // namespace

TEST_CASE("readme: its game runs, falls, bounces and is the one in games/hello", "[readme]") {
  const std::string text = first_game(tumble::read_source(tumble::source_tree("README.md")));
  CHECK(text == tumble::read_source(tumble::source_tree("games/hello/main.lua")));
  TestGame game(Files{{"main.lua", text}});

  // From y = 3 to the floor's top at 0.1 with a radius of 0.3: 2.6 m, sqrt(2 * 2.6 / 9.81) = 0.728 s, tick 44.
  game.tick(43);
  const double falling = game.position("ball").y;
  game.tick(12);
  const double rising = game.position("ball").y;

  CHECK(game.failures.empty());
  CHECK(falling < 0.7);
  CHECK(rising > falling + 0.3);
}
