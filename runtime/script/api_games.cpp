// A game that is a list of games: finding the others in its folder and opening one.
#include <algorithm>

#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

constexpr std::string_view kScript = ".lua", kMain = "/main.lua";

// The first comment of a text, without its dashes, as one line.
std::string first_comment(const std::string& text) {
  std::string words;
  for (std::size_t at = 0; at < text.size() && text.compare(at, 2, "--") == 0;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t begin = text.find_first_not_of("- \t", at);
    if (begin == std::string::npos || begin > end) begin = end;
    std::string line = text.substr(begin, end - begin);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
    words += (words.empty() || line.empty() ? "" : " ") + line;
    at = end + 1;
  }
  return words;
}

// Whatever lies beside or below a main.lua belongs to that game; every other script is a game by itself.
std::vector<std::string> games_in(const std::vector<std::string>& files) {
  std::vector<std::string> games;
  for (const std::string& file : files)
    if (file.ends_with(kMain)) games.push_back(file.substr(0, file.size() - kMain.size()));
  const std::vector<std::string> folders = games;
  for (const std::string& file : files) {
    const auto inside = [&](const std::string& folder) { return file.starts_with(folder + "/"); };
    if (file.ends_with(kScript) && file.find('/') != file.npos && std::none_of(folders.begin(), folders.end(), inside)) games.push_back(file);
  }
  std::sort(games.begin(), games.end());
  return games;
}

Value games(Script& s) {
  List list;
  for (const std::string& path : games_in(s.host().list(""))) {
    const std::string text = s.host().read(path.ends_with(kScript) ? path : path + std::string(kMain)).value_or("");
    list.push_back(Map{{"path", path}, {"about", first_comment(text)}});
  }
  return list;
}

void open(Script& s, std::string path) {
  const std::vector<std::string> known = games_in(s.host().list(""));
  if (std::find(known.begin(), known.end(), path) == known.end())
    fail("game.open: no game '", path, "' in this folder", did_you_mean(path, known), known.empty() ? "" : "; game.list() has their paths");
  s.requests.open = path;
}

}  // namespace

void rows_games(Area& a) {
  a.fn<games>("list", "The games in the folders of this one, for a menu: { path, about } each. A folder with a main.lua is a game, and so is "
                      "every other script in a folder; about is its first comment.").gives("list of table");
  a.fn<open>("open", "Plays one of them at the end of the tick, from its start; F1 or its game.quit() comes back.", "path").acts();
}

}  // namespace tumble
