// Writing into described structs by a dotted path, as reload, joints and tools do.
#pragma once

#include <string>
#include <string_view>

#include "base/describe.h"
#include "engine/node_def.h"

namespace tumble {

// "body.mass" of "body.mass.x" ... : the part before the first dot, and what follows it.
std::pair<std::string_view, std::string_view> split_path(std::string_view path);

// Writes the field that `path` leads to: names joined by dots, a number for an entry of a list, counted from 1. Nil
// empties an optional field and sets any other back to its default. Throws Error beginning with `where`.
void assign_path(const Type& type, void* object, std::string_view path, const Value& value, const std::string& where);

// The same for a node's def, where "color" is the material's.
void assign_path(NodeDef& def, std::string_view path, const Value& value, const std::string& where);

}  // namespace tumble
