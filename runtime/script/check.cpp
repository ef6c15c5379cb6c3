#include "script/check.h"

#include <algorithm>

#include "base/error.h"
#include "engine/json.h"
#include "script/check_parts.h"
#include "script/document.h"
#include "script/embedded.h"
#include "script/lua.h"

namespace tumble {

namespace {

// Only compiles; nothing of the game runs here.
std::string syntax_error(const std::string& text, const std::string& path) {
  lua_State* L = luaL_newstate();
  const int status = luaL_loadbufferx(L, text.data(), text.size(), ("@" + path).c_str(), "t");
  const std::string message = status == LUA_OK ? "" : lua_tostring(L, -1);
  lua_close(L);
  return message;
}

// "main.lua:7: what" -> line 7, "what".
CheckFinding finding_of(const std::string& path, const std::string& message) {
  CheckFinding finding{path, 0, message, true};
  if (!message.starts_with(path + ":")) return finding;
  const std::size_t begin = path.size() + 1, end = message.find(": ", begin);
  if (end == std::string::npos) return finding;
  finding.line = std::atoi(message.c_str() + begin);
  finding.text = message.substr(end + 2);
  return finding;
}

void gather_value(const Value& value, Check& check) {
  if (const std::string* text = value.get<std::string>()) ++check.literals[*text];
  if (const List* list = value.get<List>())
    for (const Value& entry : *list) gather_value(entry, check);
  if (const Map* map = value.get<Map>())
    for (const auto& [key, entry] : *map) {
      check.words.insert(key);
      ++check.literals[key];
      gather_value(entry, check);
    }
}

bool opens_names(const Token& token) { return token.is("local") || token.is("for") || token.is("("); }

// Is the word at i given a value: `a.x =`, or `a.x, a.y =`?
bool is_target(const std::vector<Token>& t, std::size_t i) {
  std::size_t k = i + 1;
  while (t[k].is(",") && t[k + 1].is_name()) {
    k += 2;
    while (t[k].is(".") && t[k + 1].is_name()) k += 2;
  }
  return t[k].is("=");
}

// What a text defines and what it only uses. Flow does not matter: a name that is given something anywhere is known.
void gather_text(const LuaText& text, Check& check) {
  const std::vector<Token>& t = text.tokens;
  for (std::size_t i = 0; t[i].kind != Token::Kind::end; ++i) {
    if (t[i].is_text()) {
      ++check.literals[t[i].text];
      if (t[i + 1].is("..")) check.endings.insert(t[i].text);
      check.words.insert(t[i].text);
    }
    if (!t[i].is_name()) continue;
    const bool is_field = i > 0 && (t[i - 1].is(".") || t[i - 1].is(":"));
    const bool after_function = i > 0 && t[i - 1].is("function");
    // `x =`, `x, y =`, `local x`, `for x`, parameters, `function x`, `function a.b:x`.
    const bool written = t[i + 1].is("=") || t[i + 1].is(",") || (i > 0 && (opens_names(t[i - 1]) || t[i - 1].is(","))) || after_function;
    const bool method = is_field && i > 2 && t[i + 1].is("(") && (t[i - 3].is("function") || (i > 4 && t[i - 5].is("function")));
    if (is_field ? is_target(t, i) || method : written) check.words.insert(t[i].text);
    if (is_field && !method && !text.of_engine) check.reads.insert(t[i].text);
    if ((after_function && t[i + 1].is("(")) || method) check.handlers.insert(t[i].text);
  }
}

void read_texts(Check& check) {
  for (const std::string& path : check.game.files) {
    if (!path.ends_with(".lua")) continue;
    const std::optional<std::string> content = check.game.read(path);
    if (!content) continue;
    const std::string message = syntax_error(*content, path);
    if (!message.empty()) check.findings.push_back(finding_of(path, message));
    check.texts.push_back({path, false, lua_tokens(*content)});
    check.words.insert(path.substr(path.find_last_of('/') + 1, path.size() - path.find_last_of('/') - 5));
  }
  for (const std::string& path : embedded_scripts())
    if (path.starts_with("std/")) check.texts.push_back({path, true, lua_tokens(embedded_script(path))});
  for (const LuaText& text : check.texts) gather_text(text, check);
}

void read_jsons(Check& check) {
  for (const std::string& path : check.game.files) {
    if (!path.ends_with(".json") || path == "game.json") continue;
    const std::optional<std::string> content = check.game.read(path);
    if (!content) continue;
    try {
      const Value value = parse_json(*content, path);
      gather_value(value, check);
      if (value.find("tumble")) check.scenes[path] = value;
    } catch (const Error& error) {
      check.findings.push_back(finding_of(path, error.what()));
    }
  }
}

void read_game_json(Check& check) {
  const std::optional<std::string> content = check.has_file("game.json") ? check.game.read("game.json") : std::nullopt;
  if (!content) return;
  try {
    gather_value(parse_json(*content, "game.json"), check);
    check.settings = read_settings(*content, "game.json");
    check.input.set_actions(check.settings.actions);
  } catch (const Error& error) {
    check.findings.push_back(finding_of("game.json", error.what()));
  }
}

}  // namespace

bool Check::has_file(const std::string& path) const { return std::binary_search(game.files.begin(), game.files.end(), path); }

bool Check::has_script(const std::string& name) const {
  const std::string path = name.ends_with(".lua") ? name : name + ".lua";
  return has_file(path) || !embedded_script("std/" + path).empty();
}

std::vector<std::string> Check::script_names() const {
  std::vector<std::string> names;
  for (const LuaText& text : texts) names.push_back(text.path.substr(text.of_engine ? 4 : 0, text.path.size() - (text.of_engine ? 8 : 4)));
  return names;
}

std::vector<std::string> Check::scene_names() const {
  std::vector<std::string> names;
  for (const auto& [path, value] : scenes) names.push_back(path.substr(0, path.size() - 5));
  return names;
}

bool Check::is_built(const std::string& name) const {
  return std::any_of(endings.begin(), endings.end(), [&](const std::string& part) { return !part.empty() && name.starts_with(part); });
}

std::vector<CheckFinding> check_game(const CheckedGame& game) {
  Check check{game, {}, {}, {}, {}, api_words(), {}, {}, {}, {}, {}};
  read_game_json(check);
  read_jsons(check);
  read_texts(check);
  check_words(check);
  check_texts(check);
  check_scenes(check);
  std::stable_sort(check.findings.begin(), check.findings.end(), [](const CheckFinding& a, const CheckFinding& b) {
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  });
  return check.findings;
}

}  // namespace tumble
