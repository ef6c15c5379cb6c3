// What the parts of a check share: check.cpp gathers, check_words.cpp and check_files.cpp look.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/value.h"
#include "engine/input_map.h"
#include "engine/settings.h"
#include "script/check.h"
#include "script/check_lexer.h"

namespace tumble {

struct LuaText {
  std::string path;
  bool of_engine = false;              // of scripts/std: its words count, its faults do not
  std::vector<Token> tokens;
};

struct Check {
  const CheckedGame& game;
  GameSettings settings;
  InputMap input;
  std::vector<LuaText> texts;
  std::map<std::string, Value> scenes; // path with ending -> content, of those that could be read
  std::set<std::string> words;         // every name that the engine, a text or a file of the game gives something
  std::set<std::string> reads;         // names that texts of the game read as fields
  std::map<std::string, int> literals; // texts in quotes, here and in JSON -> how often
  std::set<std::string> endings;       // literals that another text is joined to: "levels/" .. n
  std::set<std::string> handlers;      // names of functions: "on_basket"
  std::vector<CheckFinding> findings;

  void error(const std::string& file, int line, const std::string& text) { findings.push_back({file, line, text, true}); }
  void warn(const std::string& file, int line, const std::string& text) { findings.push_back({file, line, text, false}); }
  bool has_file(const std::string& path) const;
  // A script by the name that require and behaviours take.
  bool has_script(const std::string& name) const;
  std::vector<std::string> script_names() const;
  std::vector<std::string> scene_names() const;     // without ending
  // Does a text build such a name from parts?
  bool is_built(const std::string& name) const;
};

void check_words(Check& check);   // names in Lua texts
void check_texts(Check& check);   // texts in quotes that name something: files, actions, colours, messages
void check_scenes(Check& check);  // scene files, and what nothing reaches
// Every name of the API, fields of options tables too.
std::set<std::string> api_words();
std::set<std::string> global_words();

}  // namespace tumble
