// Bodies.
#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

BodyComponent& component(Script& s, BodyRef b) { return *s.engine().body(b.node); }
World& world(Script& s) { return *s.engine().world(); }
BodyId id(Script& s, BodyRef b) { return component(s, b).id; }
// At the top level of a file a body is only a description.
bool is_live(Script& s, BodyRef b) { return static_cast<bool>(component(s, b).id); }

void configure(Script& s, BodyRef b, const char* field, Vec3 BodyDef::* member, Vec3 value) {
  BodyDef def = s.engine().body_def(b.node);
  def.*member = value;
  s.engine().configure_body(b.node, def, field);
}

Vec3 velocity(Script& s, BodyRef b) { return is_live(s, b) ? world(s).velocity(id(s, b)) : component(s, b).def.velocity; }
void set_velocity(Script& s, BodyRef b, Vec3 v) {
  if (is_live(s, b)) world(s).set_velocity(id(s, b), v);
  else configure(s, b, "body.velocity", &BodyDef::velocity, v);
}
Vec3 angular_velocity(Script& s, BodyRef b) {
  return is_live(s, b) ? world(s).angular_velocity(id(s, b)) : component(s, b).def.angular_velocity;
}
void set_angular_velocity(Script& s, BodyRef b, Vec3 v) {
  if (is_live(s, b)) world(s).set_angular_velocity(id(s, b), v);
  else configure(s, b, "body.angular_velocity", &BodyDef::angular_velocity, v);
}
void set_velocity_hot(Script& s, BodyRef b, Vec3 v) { set_velocity(s, b, v); }
void set_angular_velocity_hot(Script& s, BodyRef b, Vec3 v) { set_angular_velocity(s, b, v); }

using Numbers = std::tuple<double, double, double>;
Numbers get_velocity(Script& s, BodyRef b) {
  const Vec3 v = velocity(s, b);
  return {v.x, v.y, v.z};
}
Numbers get_angular_velocity(Script& s, BodyRef b) {
  const Vec3 v = angular_velocity(s, b);
  return {v.x, v.y, v.z};
}

double mass(Script& s, BodyRef b) {
  if (is_live(s, b)) return world(s).mass_properties(id(s, b)).mass;
  return component(s, b).def.mass.value_or(1);
}
void set_mass(Script& s, BodyRef b, double kg) {
  if (kg <= 0) fail("body.mass: must be above 0 (got ", number_text(kg), "); a body that nothing moves is type = \"static\"");
  BodyDef def = s.engine().body_def(b.node);
  def.mass = kg;
  def.density.reset();
  s.engine().configure_body(b.node, def, "body.mass");
}

NodeRef node(Script&, BodyRef b) { return {b.node}; }
bool is_asleep(Script& s, BodyRef b) { return is_live(s, b) && world(s).asleep(id(s, b)); }
Vec3 momentum(Script& s, BodyRef b) { return is_live(s, b) ? world(s).momentum(id(s, b)) : Vec3{}; }
double kinetic_energy(Script& s, BodyRef b) { return is_live(s, b) ? world(s).kinetic_energy(id(s, b)) : 0; }
Vec3 inertia(Script& s, BodyRef b) { return is_live(s, b) ? world(s).mass_properties(id(s, b)).inertia : component(s, b).def.inertia.value_or(Vec3{}); }
void set_inertia(Script& s, BodyRef b, std::optional<Vec3> moments) {
  BodyDef def = s.engine().body_def(b.node);
  assign(type_of<BodyDef>(), &def, Map{{"inertia", moments ? Value(*moments) : Value()}}, "body");
  s.engine().configure_body(b.node, def, "body.inertia");
}
Vec3 center_of_mass(Script& s, BodyRef b) { return is_live(s, b) ? world(s).mass_properties(id(s, b)).center : component(s, b).def.center_of_mass.value_or(Vec3{}); }
void set_center_of_mass(Script& s, BodyRef b, std::optional<Vec3> place) {
  BodyDef def = s.engine().body_def(b.node);
  def.center_of_mass = place;
  s.engine().configure_body(b.node, def, "body.center_of_mass");
}
Vec3 velocity_at(Script& s, BodyRef b, Vec3 point) { return world(s).velocity_at(id(s, b), point); }

void apply_force(Script& s, BodyRef b, Vec3 force, std::optional<Vec3> point) {
  if (point) world(s).apply_force(id(s, b), force, *point);
  else world(s).apply_force(id(s, b), force);
}
void apply_torque(Script& s, BodyRef b, Vec3 torque) { world(s).apply_torque(id(s, b), torque); }
void apply_impulse(Script& s, BodyRef b, Vec3 impulse, std::optional<Vec3> point) {
  if (point) world(s).apply_impulse(id(s, b), impulse, *point);
  else world(s).apply_impulse(id(s, b), impulse);
}
void apply_angular_impulse(Script& s, BodyRef b, Vec3 impulse) { world(s).apply_angular_impulse(id(s, b), impulse); }
void sleep(Script& s, BodyRef b) { world(s).sleep(id(s, b)); }
void wake(Script& s, BodyRef b) { world(s).wake(id(s, b)); }

Results contacts(Script& s, BodyRef b) {
  lua_State* L = s.stack();
  lua_newtable(L);
  lua_Integer n = 0;
  for (const ContactEvent& event : world(s).contacts(id(s, b))) {
    push_hit(L, s.hit_of(event, id(s, b)));
    lua_rawseti(L, -2, ++n);
  }
  return {1};
}
std::vector<NodeRef> overlapping(Script& s, BodyRef b) {
  std::vector<NodeRef> nodes;
  for (const BodyId other : world(s).overlapping(id(s, b))) nodes.push_back({s.engine().node_of(other)});
  return nodes;
}
void add_collider(Script& s, BodyRef b, Value collider) {
  BodyDef def = s.engine().body_def(b.node);
  if (def.colliders.empty()) fail("body:add_collider: this body's collider is fitted to its mesh; give colliders = { ... } instead");
  assign(def.colliders.emplace_back(), collider, "body:add_collider");
  s.engine().configure_body(b.node, def, "body:add_collider");
}

}  // namespace

void rows_body(Area& a) {
  a.prop<node>("node", "The node that it moves.");
  a.prop<velocity, set_velocity>("velocity", "Of the centre of mass in the world, m/s.");
  a.prop<angular_velocity, set_angular_velocity>("angular_velocity", "In the world, rad/s.");
  a.prop<mass, set_mass>("mass", "Mass, kg; 0 is read of a static or kinematic body.");
  a.prop<is_asleep>("is_asleep", "Is it at rest and left out of the simulation until something touches it?");
  a.prop<momentum>("momentum", "Mass times velocity, kg m/s.");
  a.prop<kinetic_energy>("kinetic_energy", "Of its motion and its spin, J.");
  a.prop<inertia, set_inertia>("inertia", "Principal moments of inertia, kg m^2; nil gives them back to the colliders.");
  a.prop<center_of_mass, set_center_of_mass>("center_of_mass", "In the body's frame, m; nil gives it back to the colliders.");
  a.method<velocity_at>("velocity_at", "The velocity of the body's point at a place in the world, m/s.", "point").queries();
  a.method<apply_force>("apply_force", "Pushes for this tick, N, at the centre of mass or at a point of the world. Give it every tick.", "force", "point").acts();
  a.method<apply_torque>("apply_torque", "Twists for this tick, N m.", "torque").acts();
  a.method<apply_impulse>("apply_impulse", "Kicks once, N s, at the centre of mass or at a point of the world.", "impulse", "point").acts();
  a.method<apply_angular_impulse>("apply_angular_impulse", "Spins once, N m s.", "impulse").acts();
  a.method<sleep>("sleep", "Puts it to sleep until something wakes it.").acts();
  a.method<wake>("wake", "Wakes it.").acts();
  a.method<contacts>("contacts", "What touches it now.").queries().gives("list of hit");
  a.method<overlapping>("overlapping", "The nodes in its triggers, or whose triggers it is in.").queries();
  a.method<add_collider>("add_collider", "Adds a shape to it.", "collider").writes().takes(0, "collider");
  a.method<get_velocity>("get_velocity", "Its velocity as three numbers.");
  a.method<set_velocity_hot>("set_velocity", "Sets its velocity.", "velocity").writes();
  a.method<get_angular_velocity>("get_angular_velocity", "Its angular velocity as three numbers.");
  a.method<set_angular_velocity_hot>("set_angular_velocity", "Sets its angular velocity.", "velocity").writes();
}

}  // namespace tumble
