// Copies of prefabs: a node table laid over another one, field by field.
#pragma once

#include <string>

#include "base/describe.h"

namespace tumble {

// `over` laid over `base`, both as files or scripts write them, short forms included. Structures merge field by field,
// `behaviours` property by property, children of the same name too (others are appended); a nil in `over` takes the
// value away; all else, lists too, is replaced.
Value merged(const Type& type, const Value& base, const Value& over);

// What a prefab's table becomes in the copy that `over` describes: ids inside are dropped, or begin with the copy's own id
// where it has one, so that two copies never share one; and what joints inside call `b` still is found. References
// inside are names or paths from the prefab's root.
Value prefab_copy(const Value& prefab, const Value& over, const std::string& file);

}  // namespace tumble
