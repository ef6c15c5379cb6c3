// Nodes and their plain components.
#include <algorithm>

#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

SceneNode& node_of(Script& s, NodeRef n) { return s.engine().scene[n.id]; }

std::string id(Script& s, NodeRef n) { return node_of(s, n).id; }
std::string name(Script& s, NodeRef n) { return node_of(s, n).name; }
void set_name(Script& s, NodeRef n, std::string name) { s.engine().scene.rename(n.id, name); }
std::string path(Script& s, NodeRef n) { return s.engine().scene.path(n.id); }
bool is_alive(Script& s, AnyNode n) { return s.engine().alive(n.id); }
std::vector<std::string> tags(Script& s, NodeRef n) { return node_of(s, n).tags; }
void set_tags(Script& s, NodeRef n, Value tags) { s.engine().set_field(n.id, "tags", tags, "node.tags"); }
std::optional<NodeRef> parent(Script& s, NodeRef n) {
  const NodeId parent = node_of(s, n).parent;
  return parent ? std::optional(NodeRef{parent}) : std::nullopt;
}
void set_parent(Script& s, NodeRef n, std::optional<NodeRef> parent) {
  s.engine().set_parent(n.id, parent ? parent->id : s.engine().scene.root());
}
bool visible(Script& s, NodeRef n) { return node_of(s, n).visible; }
void set_visible(Script& s, NodeRef n, bool on) { node_of(s, n).visible = on; }
bool enabled(Script& s, NodeRef n) { return node_of(s, n).enabled; }
void set_enabled(Script& s, NodeRef n, bool on) {
  s.engine().set_enabled(n.id, on);
  s.lists_changed();
}

Vec3 position(Script& s, NodeRef n) { return node_of(s, n).local.position; }
void set_position(Script& s, NodeRef n, Vec3 p) { s.engine().set_position(n.id, p); }
Quat rotation(Script& s, NodeRef n) { return node_of(s, n).local.rotation; }
void set_rotation(Script& s, NodeRef n, Quat q) { s.engine().set_rotation(n.id, q); }
Vec3 rotation_degrees(Script& s, NodeRef n) {
  const Vec3 e = to_euler(node_of(s, n).local.rotation);
  return {degrees(e.x), degrees(e.y), degrees(e.z)};
}
void set_rotation_degrees(Script& s, NodeRef n, Vec3 e) { s.engine().set_rotation(n.id, from_euler({radians(e.x), radians(e.y), radians(e.z)})); }
Vec3 scale(Script& s, NodeRef n) { return node_of(s, n).local.scale; }
void set_scale(Script& s, NodeRef n, Vec3 v) {
  if (v.x <= 0 || v.y <= 0 || v.z <= 0) fail("node.scale: each number must be above 0 (got ", text(Value(v)), ")");
  s.engine().set_scale(n.id, v);
}
Vec3 world_position(Script& s, NodeRef n) { return s.engine().scene.world(n.id).position; }
void set_world_position(Script& s, NodeRef n, Vec3 p) { s.engine().set_world_position(n.id, p); }
Quat world_rotation(Script& s, NodeRef n) { return s.engine().scene.world(n.id).rotation; }
void set_world_rotation(Script& s, NodeRef n, Quat q) { s.engine().set_world_rotation(n.id, q); }
Vec3 forward(Script& s, NodeRef n) { return s.engine().scene.world(n.id).rotation * Vec3{0, 0, -1}; }
Vec3 right(Script& s, NodeRef n) { return s.engine().scene.world(n.id).rotation * Vec3{1, 0, 0}; }
Vec3 up(Script& s, NodeRef n) { return s.engine().scene.world(n.id).rotation * Vec3{0, 1, 0}; }

using Numbers = std::tuple<double, double, double>;
Numbers numbers(Vec3 v) { return {v.x, v.y, v.z}; }
Numbers get_position(Script& s, NodeRef n) { return numbers(position(s, n)); }
Numbers get_world_position(Script& s, NodeRef n) { return numbers(world_position(s, n)); }
Numbers get_scale(Script& s, NodeRef n) { return numbers(scale(s, n)); }

Color color(Script& s, NodeRef n) { return node_of(s, n).material.value_or(Material{}).color; }
void set_color(Script& s, NodeRef n, Color c) {
  auto& material = node_of(s, n).material;
  if (!material) material.emplace();
  material->color = c;
}

Results push_part(Script& s, NodeRef n, Tag tag, bool there) {
  if (there) s.push_component(n.id, tag);
  else lua_pushnil(s.stack());
  return {1};
}
Results body(Script& s, NodeRef n) { return push_part(s, n, Tag::body, s.engine().body(n.id)); }
Results mesh(Script& s, NodeRef n) { return push_part(s, n, Tag::mesh, node_of(s, n).mesh.has_value()); }
Results material(Script& s, NodeRef n) { return push_part(s, n, Tag::material, true); }
Results light(Script& s, NodeRef n) { return push_part(s, n, Tag::light, node_of(s, n).light.has_value()); }
Results camera(Script& s, NodeRef n) { return push_part(s, n, Tag::camera, node_of(s, n).camera.has_value()); }
Results sky(Script& s, NodeRef n) { return push_part(s, n, Tag::sky, node_of(s, n).sky.has_value()); }
Results sound(Script& s, NodeRef n) { return push_part(s, n, Tag::sound, node_of(s, n).sound.has_value()); }
Results particles(Script& s, NodeRef n) { return push_part(s, n, Tag::particles, node_of(s, n).particles.has_value()); }
Results animation(Script& s, NodeRef n) { return push_part(s, n, Tag::animation, node_of(s, n).animation.has_value()); }
Results children(Script& s, NodeRef n) { return push_part(s, n, Tag::children, true); }
void set_body(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "body", v, "node.body"); }
void set_mesh(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "mesh", v, "node.mesh"); }
void set_material(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "material", v, "node.material"); }
void set_light(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "light", v, "node.light"); }
void set_camera(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "camera", v, "node.camera"); }
void set_sky(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "sky", v, "node.sky"); }
void set_sound(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "sound", v, "node.sound"); }
void set_particles(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "particles", v, "node.particles"); }
void set_animation(Script& s, NodeRef n, Value v) { s.engine().set_field(n.id, "animation", v, "node.animation"); }
Results behaviours(Script& s, NodeRef n) { return s.push_behaviours(n.id); }

NodeRef get(Script& s, NodeRef n, std::string path) { return {s.engine().scene.get_by_path(path, n.id, "node:get")}; }
std::optional<NodeRef> find(Script& s, NodeRef n, std::string path) {
  const NodeId node = s.engine().scene.find(path, n.id);
  return node ? std::optional(NodeRef{node}) : std::nullopt;
}
std::optional<JointArg> joint(Script& s, NodeRef n, std::string name) {
  const JointRef joint = s.engine().find_joint(n.id, name);
  return joint ? std::optional(JointArg{joint}) : std::nullopt;
}
std::vector<JointArg> joints(Script& s, NodeRef n) {
  std::vector<JointArg> list;
  for (const JointRef joint : s.engine().joints_of(n.id)) list.push_back({joint});
  return list;
}
bool has_tag(Script& s, NodeRef n, std::string tag) {
  const auto& tags = node_of(s, n).tags;
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}
void translate(Script& s, NodeRef n, Vec3 offset, std::optional<double> factor) {
  s.engine().set_position(n.id, node_of(s, n).local.position + offset * factor.value_or(1));
}
// The call that moves the most nodes: with nodes, kept vectors and numbers as expected it goes straight to the scene,
// about a third of the way; whatever else it finds it leaves to the bound function's checks and words.
int translate_hot(lua_State* L) {
  Script& s = script_of(L);
  const NodeId* id = object_at<NodeId>(L, 1, Tag::node);
  const Vec3* offset = vec3_at(L, 2);
  if (id && offset && s.phase() == Phase::run && lua_gettop(L) == 3 && lua_type(L, 3) == LUA_TNUMBER) {
    Engine& engine = s.live_engine();
    const SceneNode* node = engine.scene.get(*id);
    const Vec3 way = *offset * lua_tonumber(L, 3);
    if (node && is_finite(way)) {
      engine.set_position(*id, node->local.position + way);
      return 0;
    }
  }
  return detail::Bound<translate>::call(L);
}
void turn(Script& s, NodeRef n, Vec3 axis, double angle) {
  if (axis == Vec3{}) fail("node:turn: axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  s.engine().set_rotation(n.id, normalized(node_of(s, n).local.rotation * axis_angle(axis, angle)));
}
void look_at(Script& s, NodeRef n, Vec3 point) {
  const Vec3 way = point - s.engine().scene.world(n.id).position;
  if (way != Vec3{}) s.engine().set_world_rotation(n.id, look_rotation(way));
}
void set_position_hot(Script& s, NodeRef n, Vec3 p) { s.engine().set_position(n.id, p); }
Vec3 to_world(Script& s, NodeRef n, Vec3 p) { return to_parent(s.engine().scene.world(n.id), p); }
Vec3 to_local(Script& s, NodeRef n, Vec3 p) { return from_parent(s.engine().scene.world(n.id), p); }
void teleport(Script& s, NodeRef n, Vec3 p, std::optional<Quat> q) { s.engine().teleport(n.id, p, q); }
void destroy(Script& s, NodeRef n) {
  if (n.id == s.engine().scene.root()) fail("node:destroy: the root of the scene cannot be destroyed");
  s.destroy_node(n.id);
}
int send(lua_State* L) {
  return at_border(L, [L] {
    if (tag_at(L, 1) != Tag::node) fail("node:send: node expected before the colon, got ", describe_argument(L, 1), "; was it called with a dot? Write node:send(...)");
    return script_of(L).send_message(1, 2);
  });
}

// ---- children
int children_length(lua_State* L) {
  return at_border(L, [L] {
    const NodeId node = object_at<ComponentData>(L, 1, Tag::children)->node;
    const SceneNode* n = script_of(L).engine().scene.get(node);
    if (!n) fail("node.children: ", script_of(L).dead_node_text(node));
    return lua_pushinteger(L, static_cast<lua_Integer>(n->children.size())), 1;
  });
}
int children_index(lua_State* L) {
  return at_border(L, [L] {
    const NodeId node = object_at<ComponentData>(L, 1, Tag::children)->node;
    const SceneNode* n = script_of(L).engine().scene.get(node);
    if (!n) fail("node.children: ", script_of(L).dead_node_text(node));
    if (!lua_isinteger(L, 2)) fail("node.children: a number from 1 to ", n->children.size(), " expected, got ", describe_argument(L, 2));
    const lua_Integer i = lua_tointeger(L, 2);
    if (i < 1 || i > static_cast<lua_Integer>(n->children.size())) return lua_pushnil(L), 1;
    script_of(L).push_node(n->children[static_cast<std::size_t>(i) - 1]);
    return 1;
  });
}

// ---- particles
void burst(Script& s, ComponentRef c, int count) {
  constexpr int most = ParticleField::kMost;
  if (count < 1 || count > most) fail("particles:burst: count: 1 to ", most, " expected, got ", count);
  if (!node_of(s, {c.node}).particles) fail("particles:burst: node '", node_of(s, {c.node}).name, "' has no particles any more");
  s.engine().burst_particles(c.node, count);
}

// ---- camera
std::tuple<double, double, bool> to_screen_point(Script& s, ComponentRef c, Vec3 point) {
  double x = 0, y = 0;
  const bool in_front = to_screen(s.view_of(c.node), point, s.aspect, x, y);
  return {x, y, in_front};
}
std::tuple<Vec3, Vec3> ray(Script& s, ComponentRef c, double x, double y) {
  const auto [from, direction] = camera_ray(s.view_of(c.node), x, y, s.aspect);
  return {from, from + direction * s.view_of(c.node).far};
}

}  // namespace

void rows_node(Area& a) {
  a.prop<name, set_name>("name", "Its name; paths are names joined by '/'.");
  a.prop<id>("id", "Its lasting id, the same after saving and loading.");
  a.prop<path>("path", "The names from the top of the scene down to it.");
  a.prop<tags, set_tags>("tags", "Words to find it by: scene.tagged(\"coin\").");
  a.prop<parent, set_parent>("parent", "The node it hangs from; its place in the world is kept when it is hung elsewhere.");
  a.prop<children>("children", "Its children, to be read.").gives("list of node");
  a.prop<visible, set_visible>("visible", "Is it drawn?");
  a.prop<enabled, set_enabled>("enabled", "Off: no drawing, no body, no updates, for its children too.");
  a.prop<is_alive>("is_alive", "False once it was destroyed.");
  a.prop<position, set_position>("position", "Relative to the parent, m. Written, it moves there; a dynamic body jumps.");
  a.prop<rotation, set_rotation>("rotation", "Relative to the parent.");
  a.prop<rotation_degrees, set_rotation_degrees>("rotation_degrees", "The same as Euler angles, turned first about y, then x, then z.");
  a.prop<scale, set_scale>("scale", "Relative to the parent; each number above 0.");
  a.prop<world_position, set_world_position>("world_position", "In the world, m.");
  a.prop<world_rotation, set_world_rotation>("world_rotation", "In the world.");
  a.prop<forward>("forward", "Its -z direction in the world.");
  a.prop<right>("right", "Its x direction in the world.");
  a.prop<up>("up", "Its y direction in the world.");
  a.prop<color, set_color>("color", "The colour of its material.");
  a.prop<mesh, set_mesh>("mesh", "What it looks like, or nil.").gives("mesh or nil");
  a.prop<material, set_material>("material", "How its surface looks.").gives("material");
  a.prop<light, set_light>("light", "The light that shines from it, or nil.").gives("light or nil");
  a.prop<camera, set_camera>("camera", "The camera that looks from it, or nil.").gives("camera or nil");
  a.prop<sky, set_sky>("sky", "The sky and fog that it brings, or nil.").gives("sky or nil");
  a.prop<sound, set_sound>("sound", "What is heard from it, or nil.").gives("sound or nil");
  a.prop<particles, set_particles>("particles", "The small sprites that rise from it, or nil.").gives("particles or nil");
  a.prop<animation, set_animation>("animation", "The keyframes that move it, or nil.").gives("animation or nil");
  a.prop<body, set_body>("body", "Its physical body, or nil.").gives("body or nil");
  a.rows.emplace_back(Row{Row::Kind::property, a.name, "behaviours", "Its behaviours by name: node.behaviours.slime.", {}, "table", nullptr,
                          &detail::Bound<behaviours>::call, nullptr, Permit::always, true, false});
  detail::Bound<behaviours>::row = &a.rows.back();
  a.method<get>("get", "The descendant of that name or path; an error where there is none.", "path");
  a.method<find>("find", "The descendant of that name or path, or nil.", "path");
  a.method<joint>("joint", "The joint of that name at this node, from either end, or nil.", "name");
  a.method<joints>("joints", "All joints at this node.");
  a.method<has_tag>("has_tag", "Does it have that tag?", "tag");
  a.raw("send", "Calls on_<message> in this node's slot and behaviours, at once; true if anyone listened.", send,
        {{"message", "string", false}, {"...", "any", true}}, "boolean").acts().method = true;
  a.method<translate>("translate", "Moves it by an offset (times a factor), in its parent's space.", "offset", "factor").writes().call = translate_hot;
  a.method<turn>("turn", "Turns it about one of its own axes.", "axis", "radians").writes();
  a.method<look_at>("look_at", "Turns it so that its forward points at a point of the world.", "point").writes();
  a.method<to_world>("to_world", "A point of its space in the world.", "point");
  a.method<to_local>("to_local", "A point of the world in its space.", "point");
  a.method<teleport>("teleport", "Jumps: nothing is drawn in between, contacts end, velocity stays.", "position", "rotation").writes();
  a.method<destroy>("destroy", "Ends it and its children at the end of the tick; is_alive is false at once.").acts();
  a.method<get_position>("get_position", "Its position as three numbers.");
  a.method<set_position_hot>("set_position", "Sets its position.", "position").writes();
  a.method<get_world_position>("get_world_position", "Its world position as three numbers.");
  a.method<get_scale>("get_scale", "Its scale as three numbers.");
  a.event("update", "Each tick.", {{"dt", "number"}});
  a.event("on_collision_enter", "A body began to touch this one.", {{"hit", "hit"}});
  a.event("on_collision_stay", "A body goes on touching this one; told only where a handler exists.", {{"hit", "hit"}});
  a.event("on_collision_exit", "A body ceased to touch this one.", {{"hit", "hit"}});
  a.event("on_trigger_enter", "A body came into this trigger, or this body into a trigger.", {{"hit", "hit"}});
  a.event("on_trigger_stay", "It is still inside.", {{"hit", "hit"}});
  a.event("on_trigger_exit", "It left.", {{"hit", "hit"}});
  a.event("on_joint_break", "A joint of this body broke.", {{"joint", "joint"}});
  a.event("on_animation_end", "A clip that does not loop came to its end.", {{"clip", "string"}});
  a.event("on_sleep", "The body fell asleep.", {});
  a.event("on_wake", "The body woke.", {});
}

void rows_children(Area&) {}
void rows_mesh(Area&) {}
void rows_material(Area&) {}
void rows_light(Area&) {}
void rows_sky(Area&) {}
void rows_particles(Area& a) {
  a.method<burst>("burst", "So many begin at once, where the node is now.", "count").acts();
}
void rows_animation(Area&) {}
void rows_camera(Area& a) {
  a.method<to_screen_point>("to_screen", "Where a point of the world is on the screen, in ui units, and whether it is in front.", "point");
  a.method<ray>("ray", "The two ends of the line of sight through a place on the screen.", "x", "y");
}
void rows_view(Area&) {}

void open_children(lua_State* L) {
  push_metatable(L, Tag::children);
  lua_pushcfunction(L, children_length);
  lua_setfield(L, -2, "__len");
  lua_pushcfunction(L, children_index);
  lua_setfield(L, -2, "__index");
  lua_pop(L, 1);
}

}  // namespace tumble
