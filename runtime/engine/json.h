// JSON to Value and back. The one place that knows the JSON library.
#pragma once

#include <string>

#include "base/value.h"

namespace tumble {

// Whole numbers become integers, all others doubles; a list of three numbers stays a List. Throws Error with file, line
// and column at a syntax error ("game.json:3:7: ..."), at a key that stands twice in one table, at tables more than 100
// deep and at texts above 64 MiB.
Value parse_json(const std::string& text, const std::string& file);
// Two spaces of indent; short lists and tables stay on one line, so that diffs are readable. vec3 is [x, y, z], quat
// [x, y, z, w], color "#rrggbb" or "#rrggbbaa", or [r, g, b, a] where that is not exact. Ends with a line feed. Throws
// Error at what JSON has no form for: NaN, infinity, nodes, joints.
std::string write_json(const Value& value);

}  // namespace tumble
