// The API's documents and the editor's types, written from the rows and described structs: docs/api/*.md and
// scripts/types/*.d.lua. They are committed; tests/script/test_generated.cpp holds them to the table.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tumble {

// Path below the top folder -> text, in a fixed order.
std::vector<std::pair<std::string, std::string>> document_files();

// Every name that the documents tell of, for holding a running game against them.
struct DocumentedName {
  enum class Kind { function, property, event, field };
  std::string area;        // "scene", "node", "globals"
  bool object = false;     // of an object rather than of a module
  bool provided = false;   // by scripts/boot or Lua, not by a row of C++
  Kind kind = Kind::function;
  std::string name;
};
std::vector<DocumentedName> documented_names();

}  // namespace tumble
