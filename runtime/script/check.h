// Finds mistakes in a game without running it: syntax, names that nobody knows, files that are missing or never used.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tumble {

struct CheckFinding {
  std::string file;
  int line = 0;          // 0: of the whole file
  std::string text;
  bool is_error = true;  // else something that looks wrong and may be meant
};

// A game as the checks see it.
struct CheckedGame {
  std::function<std::optional<std::string>(const std::string& path)> read;
  std::vector<std::string> files;   // all of them, sorted
  std::string entry = "main.lua";
};

// In the order of files and lines. Never throws for what is in the game.
std::vector<CheckFinding> check_game(const CheckedGame& game);
// The names of the API in the words of luacheck's configuration, so that its rules know ours.
std::string check_config();

}  // namespace tumble
