// Scene files: one node table with "tumble": 1.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/node_def.h"

namespace tumble {

// Reads "levels/one.json"; nothing where there is no such file.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

// `path` as scripts write it, without ending. Prefabs are merged in field by field (children of the same name too).
// Throws Error naming file and the path inside it ("levels/one.json: children[3].body has no field 'mas'; ..."). Prefabs
// that hold one another, chains of more than 16 and copies of more than 100000 nodes in all are refused.
NodeDef load_scene_file(const std::string& path, const FileReader& read, const std::string& call);
// The same for a table from a script: with its prefab and those of its children merged in. What has none comes back as it
// is. Unknown keys are left for who reads the table.
Value with_prefabs(const Value& node, const FileReader& read, const std::string& call);
// Only what differs from the defaults; prefabs are written out in full.
std::string write_scene_file(const NodeDef& root);

}  // namespace tumble
