// A joint's options as scripts and files write them, and the world's JointDef.
#pragma once

#include <string>
#include <vector>

#include "physics/joint.h"
#include "scene/node.h"

namespace tumble {

// `a` is the world transform of the first node, by which its anchor is stretched; the identity where a is the world.
// `call` begins errors: "joint.hinge". The bodies are left open.
JointDef read_joint(const std::string& type, const Value& options, const Transform& a, const std::string& call);
// What differs from the defaults, as options.
Value write_joint(const JointDef& def, const Transform& a);

// Every option that joint.<type> takes, as the descriptions have them.
std::vector<std::string> joint_option_names(const std::string& type);

}  // namespace tumble
