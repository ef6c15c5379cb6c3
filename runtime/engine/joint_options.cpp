#include "engine/joint_options.h"

#include <algorithm>

#include "base/text.h"

namespace tumble {

// Instead of `anchor` and `axis`, which are relative to a.
struct WorldFrame {
  std::optional<Vec3> world_anchor, world_axis;
};
void describe(WorldFrame& frame, Schema& s) {
  s.name("joint in the world", "Where a joint is, in the world instead of a's frame.");
  s.add("world_anchor", frame.world_anchor, "Instead of the anchor: its place in the world, m.");
  s.add("world_axis", frame.world_axis, "Instead of the axis: its direction in the world.");
  s.check<WorldFrame>([](const WorldFrame& frame) {
    if (frame.world_axis == Vec3{}) fail("world_axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  });
}

namespace {

std::vector<std::string> option_names(const Type& kind) {
  std::vector<std::string> names = type_of<JointDef>().field_names();
  for (const std::string& more : type_of<WorldFrame>().field_names()) names.push_back(more);
  for (const std::string& more : kind.field_names()) names.push_back(more);
  return names;
}

bool has(const Type& type, std::string_view name) { return type.field(name) || type.field_in_degrees(name); }

// The options, parted by who reads them.
struct Parts {
  Map common, frame, kind;
};

Parts part(const Map& options, const Type& kind, const std::string& call) {
  Parts parts;
  for (const auto& [name, value] : options) {
    Map* map = nullptr;
    for (const auto& [type, its] : {std::pair{&type_of<JointDef>(), &parts.common}, std::pair{&type_of<WorldFrame>(), &parts.frame},
                                    std::pair{&kind, &parts.kind}})
      if (has(*type, name)) map = its;
    if (map) {
      map->emplace_back(name, value);
      continue;
    }
    const std::vector<std::string> names = option_names(kind);
    const std::string hint = did_you_mean(name, names);
    fail(call, ": no field '", name, "'", hint.empty() ? "; it has " + join(names) : hint);
  }
  return parts;
}

void refuse_both(const Parts& parts, const char* local, const char* world, const std::string& call) {
  if (Value(parts.common).find(local) && Value(parts.frame).find(world))
    fail(call, ": ", local, " and ", world, " are given both; give one of them");
}

}  // namespace

JointDef read_joint(const std::string& type, const Value& options, const Transform& a, const std::string& call) {
  JointDef def;
  def.kind = joint_kind(type);
  const Map none;
  const Parts parts = part(options.get<Map>() ? *options.get<Map>() : none, joint_kind_type(def.kind), call);
  refuse_both(parts, "anchor", "world_anchor", call);
  refuse_both(parts, "axis", "world_axis", call);
  WorldFrame frame;
  assign(def, parts.common, call);
  assign(frame, parts.frame, call);
  assign(joint_kind_type(def.kind), joint_kind_object(def.kind), parts.kind, call);

  // The world knows no scales: its anchors are in metres from the body's origin, along the body's axes.
  const Quat back = conjugate(a.rotation);
  def.anchor = frame.world_anchor ? back * (*frame.world_anchor - a.position) : scaled(a.scale, def.anchor);
  if (frame.world_axis) def.axis = back * *frame.world_axis;
  check_axes(def, call);
  return def;
}

Value write_joint(const JointDef& def, const Transform& a) {
  JointDef written = def;
  written.anchor = unscaled(def.anchor, a.scale);
  Value options = to_value(written, true);
  const Value kind = to_value(joint_kind_type(def.kind), joint_kind_object(def.kind), true);
  for (const auto& [name, value] : *kind.get<Map>()) options[name] = value;
  return options;
}

std::vector<std::string> joint_option_names(const std::string& type) { return option_names(joint_kind_type(joint_kind(type))); }

}  // namespace tumble
