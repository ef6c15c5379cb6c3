#include "physics/joint.h"

#include "base/text.h"

namespace tumble {

namespace {

template <std::size_t... I>
std::vector<JointKind> all_kinds(std::index_sequence<I...>) {
  return {JointKind(std::in_place_index<I>)...};
}

const std::vector<JointKind>& kinds() {
  static const std::vector<JointKind> all = all_kinds(std::make_index_sequence<std::variant_size_v<JointKind>>());
  return all;
}

// The second axis, and what the kind calls it.
std::pair<std::optional<Vec3>, const char*> second_axis(const JointKind& kind) {
  if (const auto* universal = std::get_if<UniversalDef>(&kind)) return {universal->axis_b, "axis_b"};
  if (const auto* ragdoll = std::get_if<RagdollDef>(&kind)) return {ragdoll->swing_axis, "swing_axis"};
  return {};
}

}  // namespace

void describe(JointDef& joint, Schema& s) {
  s.name("joint", "Ties two bodies together. Anchor and axis are in the first one's frame.");
  s.add("anchor", joint.anchor, "Where it is, in a's frame, m.");
  s.add("axis", joint.axis, "Its direction, in a's frame; any length but zero.");
  s.add("break_force", joint.break_force, "Breaks where it holds with more than this, N.").above(0).allow_infinite();
  s.add("break_torque", joint.break_torque, "Breaks where it holds with more than this, N m.").above(0).allow_infinite();
  s.add("collide_connected", joint.collide_connected, "Do its two bodies collide with each other?");
  s.add("enabled", joint.enabled, "Off: it holds nothing.");
  s.check<JointDef>([](const JointDef& def) {
    if (def.axis == Vec3{}) fail("axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  });
}

const std::vector<std::string>& joint_kind_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const JointKind& kind : kinds()) result.push_back(joint_kind_type(kind).name);
    return result;
  }();
  return names;
}

std::string joint_kind_name(const JointKind& kind) { return joint_kind_type(kind).name; }

JointKind joint_kind(std::string_view name) {
  for (const JointKind& kind : kinds())
    if (joint_kind_type(kind).name == name) return kind;
  fail("joint: no kind '", name, "'; the kinds are ", join(joint_kind_names()), did_you_mean(name, joint_kind_names()));
}

const Type& joint_kind_type(const JointKind& kind) {
  return *std::visit([]<class T>(const T&) { return &type_of<T>(); }, kind);
}

void* joint_kind_object(JointKind& kind) {
  return std::visit([](auto& def) -> void* { return &def; }, kind);
}

const void* joint_kind_object(const JointKind& kind) {
  return std::visit([](const auto& def) -> const void* { return &def; }, kind);
}

Quat joint_frame(const JointDef& joint) {
  const Quat frame = between({1, 0, 0}, normalized(joint.axis));
  const std::optional<Vec3> second = second_axis(joint.kind).first;
  if (!second) return frame;
  const Vec3 in_frame = conjugate(frame) * *second;
  return frame * axis_angle({1, 0, 0}, std::atan2(in_frame.z, in_frame.y));
}

void check_axes(const JointDef& joint, const std::string& call) {
  if (joint.axis == Vec3{}) fail(call, ": axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  const auto [second, name] = second_axis(joint.kind);
  if (!second) return;
  const auto text = [](Vec3 v) { return number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z); };
  if (*second == Vec3{})
    fail(call, ": ", name, " must not be zero (got 0, 0, 0); give a direction such as vec3.right, or leave it out");
  if (length(cross(normalized(joint.axis), normalized(*second))) < 1e-3)
    fail(call, ": ", name, " must not be parallel to axis (got ", text(*second), " and ", text(joint.axis),
         "); give a direction across it, or leave it out");
}

}  // namespace tumble
