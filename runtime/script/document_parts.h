// How the documents are cut into pages, for those who write them: document_page.cpp and document_types.cpp.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "script/bind.h"

namespace tumble {

// One page of docs/api and one file of scripts/types: all that goes by one word.
struct Page {
  std::string name;                     // of the file: "joint"
  std::string title, doc;
  std::vector<const Area*> areas;       // modules before objects
  std::vector<const Type*> tables;      // options tables and files, in the order of the page
  std::string notes;                    // Markdown, at the end
};
std::vector<Page> document_pages();

// Names that have no rows because scripts/boot or Lua itself provides them, in the form of rows: "globals", "handlers",
// "behaviour", "task", "bot", "math" and what hangs on vec3, quat and color themselves.
const std::deque<Area>& word_areas();
bool is_word_area(const Area& area);

// Structures in the fields of this type, itself left out, each once and in the order of the fields.
std::vector<const Type*> tables_within(const Type& type);
// What an optional, list or map holds; other types themselves.
const Type& content_of(const Type& type);
// May scripts write the property?
bool is_writable(const Row& row);
// As a script would write it; "nil" for none.
std::string lua_text(const Value& value);

std::string markdown_page(const Page& page);
std::string markdown_index(const std::vector<Page>& pages);
std::string markdown_std();              // what scripts/std says of itself
std::string lua_types(const Page& page);

}  // namespace tumble
