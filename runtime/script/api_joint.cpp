// Joints.
#include <algorithm>

#include "base/text.h"
#include "engine/joint_options.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

JointArg make(Script& s, const char* type, const Value& options) { return {s.add_joint(type, options, std::string("joint.") + type)}; }
JointArg fixed(Script& s, Value options) { return make(s, "fixed", options); }
JointArg hinge(Script& s, Value options) { return make(s, "hinge", options); }
JointArg slider(Script& s, Value options) { return make(s, "slider", options); }
JointArg cylindrical(Script& s, Value options) { return make(s, "cylindrical", options); }
JointArg ball(Script& s, Value options) { return make(s, "ball", options); }
JointArg universal(Script& s, Value options) { return make(s, "universal", options); }
JointArg ragdoll(Script& s, Value options) { return make(s, "ragdoll", options); }

JointRecord& record(Script& s, JointArg j) { return *s.engine().joint(j.id); }
JointState state(Script& s, JointArg j) {
  World* world = s.engine().world();
  const JointRecord& joint = record(s, j);
  return world && joint.id && world->has(joint.id) ? world->state(joint.id) : JointState{};
}

std::string type(Script& s, JointArg j) { return record(s, j).type; }
std::string name(Script& s, JointArg j) { return record(s, j).name; }
NodeRef a(Script& s, JointArg j) { return {record(s, j).a}; }
std::optional<NodeRef> b(Script& s, JointArg j) {
  const NodeId node = record(s, j).b;
  return node ? std::optional(NodeRef{node}) : std::nullopt;
}
double angle_or_position(Script& s, JointArg j, const char* property, const char* joint) {
  if (record(s, j).type != joint) fail("joint.", property, ": belongs to a ", joint, ", and this is a ", record(s, j).type);
  return state(s, j).position;
}
double angle(Script& s, JointArg j) { return angle_or_position(s, j, "angle", "hinge"); }
double angle_degrees(Script& s, JointArg j) { return degrees(angle_or_position(s, j, "angle_degrees", "hinge")); }
double position(Script& s, JointArg j) { return angle_or_position(s, j, "position", "slider"); }
double speed(Script& s, JointArg j) {
  for (const Field& field : joint_kind_type(record(s, j).def.kind).fields)
    if (field.type->kind == Kind::structure) fail("joint.speed: a ", record(s, j).type, " has several freedoms; read joint.", field.name, ".speed");
  return state(s, j).speed;
}
Vec3 force(Script& s, JointArg j) { return state(s, j).force; }
Vec3 torque(Script& s, JointArg j) { return state(s, j).torque; }
bool is_broken(Script& s, JointArg j) { return record(s, j).broken; }
void destroy(Script& s, JointArg j) { s.engine().destroy_joint(j.id); }

}  // namespace

bool Script::joint_has_option(const std::string& type, const std::string& name) const {
  const std::vector<std::string> names = joint_option_names(type);
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool Script::is_freedom(const JointRecord& joint, const std::string& name) const {
  const Field* field = joint_kind_type(joint.def.kind).field(name);
  return field && field->type->kind == Kind::structure;
}

std::optional<double> Script::freedom_state(JointRef joint, const std::string& freedom, const std::string& key) {
  const JointRecord* its = engine().joint(joint);
  if (!its || !is_freedom(*its, freedom)) return {};
  const bool turns = joint_kind_type(its->def.kind).field(freedom)->type->field("max")->angle;
  const bool asks = key == "speed" || (turns ? key == "angle" || key == "angle_degrees" : key == "position");
  if (!asks) return {};
  for (const FreedomState& found : state(*this, {joint}).freedoms)
    if (found.name == freedom) return key == "speed" ? found.speed : key == "angle_degrees" ? degrees(found.position) : found.position;
  return 0;  // it holds nothing now
}

void rows_joint_module(Area& m) {
  m.fn<fixed>("fixed", "Welds two bodies.", "options").writes().takes(0, "joint options");
  m.fn<hinge>("hinge", "Lets a turn about an axis (a revolute joint).", "options").writes().takes(0, "hinge options");
  m.fn<slider>("slider", "Lets a slide along an axis (a prismatic joint).", "options").writes().takes(0, "slider options");
  m.fn<cylindrical>("cylindrical", "Lets a slide along an axis and turn about it.", "options").writes().takes(0, "cylindrical options");
  m.fn<ball>("ball", "Lets a turn freely about a point (a spherical joint).", "options").writes().takes(0, "ball options");
  m.fn<universal>("universal", "Lets a turn about two axes across each other (Hooke's joint).", "options").writes().takes(0, "universal options");
  m.fn<ragdoll>("ragdoll", "Lets a bone swing within a cone and twist (a cone-twist joint).", "options").writes().takes(0, "ragdoll options");
}

void rows_joint(Area& m) {
  m.prop<type>("type", "\"fixed\", \"hinge\", \"slider\", \"cylindrical\", \"ball\", \"universal\" or \"ragdoll\".");
  m.prop<name>("name", "The name it is found by: node:joint(name).");
  m.prop<a>("a", "The first node; anchor and axis are in its space.");
  m.prop<b>("b", "The second node, or nil for the world.");
  m.prop<angle>("angle", "Of a hinge: how far a has turned against b since it was made, rad.");
  m.prop<angle_degrees>("angle_degrees", "The same in degrees.");
  m.prop<position>("position", "Of a slider: how far a has slid against b since it was made, m.");
  m.prop<speed>("speed", "Of a hinge or slider: how fast that changes, rad/s or m/s.");
  m.prop<force>("force", "What it pushed a with in the last tick, N.");
  m.prop<torque>("torque", "What it twisted a with in the last tick, N m.");
  m.prop<is_broken>("is_broken", "Has it broken?");
  m.method<destroy>("destroy", "Frees the bodies.").acts();
}

}  // namespace tumble
