// The API's documents and the editor's types, written from the rows and described structs: docs/api/*.md and
// scripts/types/*.d.lua. They are committed; tests/script/test_generated.cpp holds them to the table.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tumble {

// Path below the top folder -> text, in a fixed order.
std::vector<std::pair<std::string, std::string>> document_files();

}  // namespace tumble
