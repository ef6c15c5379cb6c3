// Texts in quotes that name something which must be there: files, scripts, scenes, actions, colours, groups, messages.
#include <algorithm>

#include "base/color.h"
#include "base/text.h"
#include "engine/node_def.h"
#include "script/check_parts.h"

namespace tumble {

namespace {

const char* const kAssetEndings[] = {".png", ".jpg", ".jpeg", ".glb", ".gltf", ".wav", ".ogg"};

bool names_an_asset(const std::string& text) {
  return std::any_of(std::begin(kAssetEndings), std::end(kAssetEndings), [&](const char* ending) { return text.size() > std::string_view(ending).size() && text.ends_with(ending); });
}

struct Place {
  const LuaText& text;
  std::size_t at;      // of the text in quotes
  const std::vector<Token>& t = text.tokens;
  const std::string& literal() const { return t[at].text; }
  bool whole() const { return !t[at + 1].is("..") && !(at > 0 && t[at - 1].is("..")); }
  // The key that it is given to: color = "red"; "" for none.
  std::string key() const { return at > 1 && t[at - 1].is("=") && t[at - 2].is_name() ? t[at - 2].text : ""; }
  // The function whose first argument it is, and what that hangs on: "scene" and "load".
  std::size_t callee() const {
    if (at == 0) return 0;
    return t[at - 1].is("(") && at > 1 ? at - 2 : at - 1;
  }
  bool is_call(const char* object, const char* function) const {
    const std::size_t f = callee();
    return f >= 2 && t[f].is(function) && t[f].is_name() && (t[f - 1].is(".") || t[f - 1].is(":")) && (!*object || t[f - 2].is(object));
  }
  bool is_call(const char* function) const {
    const std::size_t f = callee();
    return t[f].is_name() && t[f].text == function && !(f > 0 && (t[f - 1].is(".") || t[f - 1].is(":")));
  }
};

void check_file(const Place& p, Check& check) {
  const std::string& name = p.literal();
  if (!names_an_asset(name) || !p.whole() || check.has_file(name)) return;
  check.error(p.text.path, p.t[p.at].line, "no file '" + name + "' in the game" + did_you_mean(name, check.game.files));
}

void check_script(const Place& p, Check& check) {
  if (!p.is_call("require") || check.has_script(p.literal())) return;
  check.error(p.text.path, p.t[p.at].line, "require: no file '" + p.literal() + ".lua' in the game or in scripts/std" + did_you_mean(p.literal(), check.script_names()));
}

void check_scene(const Place& p, Check& check) {
  const bool loads = p.is_call("scene", "load");
  if (!(loads || p.key() == "prefab") || !p.whole() || check.has_file(p.literal() + ".json")) return;
  check.error(p.text.path, p.t[p.at].line, std::string(loads ? "scene.load" : "prefab") + ": no file '" + p.literal() + ".json' in the game" + did_you_mean(p.literal(), check.scene_names()));
}

void check_color(const Place& p, Check& check) {
  if (p.key() != "color" || !p.whole() || parse_color(p.literal())) return;
  check.error(p.text.path, p.t[p.at].line, "unknown color '" + p.literal() + "'" + did_you_mean(p.literal(), color_names()));
}

void check_input(const Place& p, Check& check) {
  bool asks = false;
  for (const char* function : {"is_down", "was_pressed", "was_released", "value", "axis", "bindings"}) asks = asks || p.is_call("input", function);
  for (const char* function : {"press", "release", "tap"}) asks = asks || p.is_call(function);
  // Inside on_press(name): name == "jump".
  const std::size_t i = p.at;
  if (i > 1 && p.t[i - 1].is("==") && p.t[i - 2].is("name")) {
    for (std::size_t k = i; k > 0 && !asks; --k) {
      if (!p.t[k].is("function")) continue;
      asks = p.t[k + 1].is("on_press") || p.t[k + 1].is("on_release") || p.t[k + 3].is("on_press") || p.t[k + 3].is("on_release");
      break;
    }
  }
  if (asks && p.whole() && !check.input.knows(p.literal()))
    check.error(p.text.path, p.t[i].line, "no key, button or action '" + p.literal() + "'" + did_you_mean(p.literal(), check.input.known_names()));
}

void check_message(const Place& p, Check& check) {
  if (!(p.is_call("", "send")) || !p.whole() || check.handlers.count("on_" + p.literal())) return;
  std::vector<std::string> messages;
  for (const std::string& handler : check.handlers)
    if (handler.starts_with("on_")) messages.push_back(handler.substr(3));
  const std::string near = did_you_mean(p.literal(), messages);
  check.findings.push_back({p.text.path, p.t[p.at].line, "nobody handles the message '" + p.literal() + "': there is no function on_" + p.literal() + near, !near.empty()});
}

void check_group(const Place& p, Check& check) {
  const std::vector<std::string>& groups = check.settings.physics.groups;
  if (p.key() != "group" || !p.whole() || std::find(groups.begin(), groups.end(), p.literal()) != groups.end()) return;
  // Sounds have groups too; what is played names its file in the same braces.
  for (std::size_t k = p.at; k > 0 && !p.t[k].is("{"); --k)
    if (p.t[k].is("file") || p.t[k].is("volume") || p.t[k].is("loop")) return;
  const std::size_t f = p.at;
  for (std::size_t k = f; k > 0 && k + 12 > f; --k)
    if (p.t[k].is("sound")) return;
  check.error(p.text.path, p.t[p.at].line, "no group '" + p.literal() + "' in the physics.groups of game.json" + did_you_mean(p.literal(), groups));
}

// A name or tag that is asked for and stands nowhere else.
void check_lookup(const Place& p, Check& check) {
  const bool tag = p.is_call("scene", "tagged") || p.is_call("", "has_tag");
  const bool name = p.is_call("scene", "get");
  if (!(tag || name) || !p.whole()) return;
  const std::string part = p.literal().substr(p.literal().find_last_of('/') + 1);
  if (check.is_built(part)) return;
  // The places that ask do not count.
  int asked = 0;
  for (const LuaText& text : check.texts)
    for (std::size_t i = 1; i + 1 < text.tokens.size(); ++i) {
      if (!text.tokens[i].is_text() || text.tokens[i].text.substr(text.tokens[i].text.find_last_of('/') + 1) != part) continue;
      const Place other{text, i};
      asked += text.tokens[i].text == part && (other.is_call("", "get") || other.is_call("", "find") || other.is_call("", "has_tag") || other.is_call("", "tagged"));
    }
  const auto found = check.literals.find(part);
  if (found != check.literals.end() && found->second > asked) return;
  std::vector<std::string> known;
  for (const auto& [literal, count] : check.literals)
    if (literal != part) known.push_back(literal);
  check.warn(p.text.path, p.t[p.at].line, std::string(tag ? "nothing has the tag '" : "nothing is called '") + part + "'" + did_you_mean(part, known));
}

// behaviours = { name = ... } and behaviours = "name".
void check_behaviours(const LuaText& text, Check& check) {
  const std::vector<Token>& t = text.tokens;
  const auto look = [&](const Token& token) {
    if (!check.has_script(token.text)) check.error(text.path, token.line, "behaviours: no file '" + token.text + ".lua' in the game or in scripts/std" + did_you_mean(token.text, check.script_names()));
  };
  for (std::size_t i = 0; t[i].kind != Token::Kind::end; ++i) {
    if (!t[i].is("behaviours") || !t[i + 1].is("=") || !t[i + 2].is("{")) continue;
    int depth = 0;
    for (std::size_t k = i + 2; t[k].kind != Token::Kind::end; ++k) {
      if (t[k].is("{")) ++depth;
      if (t[k].is("}") && --depth == 0) break;
      if (depth != 1) continue;
      if (t[k].is_name() && t[k + 1].is("=")) look(t[k]);
      if (t[k].is("[") && t[k + 1].is_text() && t[k + 2].is("]")) look(t[k + 1]);
    }
  }
}

}  // namespace

void check_texts(Check& check) {
  for (const LuaText& text : check.texts) {
    if (text.of_engine || text.path.starts_with("tests/")) continue;
    check_behaviours(text, check);
    for (std::size_t i = 1; text.tokens[i].kind != Token::Kind::end; ++i) {
      if (!text.tokens[i].is_text()) continue;
      const Place place{text, i};
      for (const auto look : {check_file, check_script, check_scene, check_color, check_input, check_message, check_group, check_lookup}) look(place, check);
    }
  }
}

}  // namespace tumble
