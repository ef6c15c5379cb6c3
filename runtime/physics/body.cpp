#include "physics/body.h"

#include <algorithm>

#include "base/text.h"

namespace tumble {

const EnumNames& enum_names(BodyType) {
  static const EnumNames names = {"dynamic", "static", "kinematic"};
  return names;
}

const EnumNames& enum_names(Combine) {
  static const EnumNames names = {"average", "min", "max", "multiply"};
  return names;
}

const EnumNames& enum_names(Fit) {
  static const EnumNames names = {"mesh", "node"};
  return names;
}

void describe(ColliderDef& collider, Schema& s) {
  describe(collider.shape, s);  // the shape's fields are the collider's own
  s.name("collider", "One shape of a body. What it leaves open holds as the body says.");
  s.main("shape");
  s.add("offset", collider.offset, "Where its centre is in the body's frame, m.");
  s.rotation("rotation", collider.rotation, "How it is turned in the body's frame.");
  s.add("friction", collider.friction, "Instead of the body's.").at_least(0);
  s.add("restitution", collider.restitution, "Instead of the body's.").at_least(0);
  s.add("density", collider.density, "Instead of the body's, kg/m^3; where the body has a mass, only its ratio to the others' counts.").above(0);
  s.add("trigger", collider.trigger, "Instead of the body's: reports what is in it and lets everything through; it has no mass.");
  s.add("name", collider.name, "To find it again.");
}

namespace {

void describe_motion(BodyDef& body, Schema& s) {
  s.add("velocity", body.velocity, "Of the centre of mass, world, m/s.");
  s.add("angular_velocity", body.angular_velocity, "World, rad/s, right-handed about its direction.");
  s.add("damping", body.damping, "1/s: a free body's speed is v0 exp(-damping t).").at_least(0);
  s.add("angular_damping", body.angular_damping, "The same for turning, 1/s.").at_least(0);
  s.add("gravity_factor", body.gravity_factor, "How much of the world's gravity pulls at it; 0 floats, -1 rises.");
  s.add("rotation_factor", body.rotation_factor, "How readily it turns about the world's x, y and z; 0 locks.").at_least(0);
  s.add("lock_position", body.lock_position, "World axes along which it cannot move: \"z\", \"xyz\".");
  s.add("lock_rotation", body.lock_rotation, "World axes about which it cannot turn: \"xz\", \"xyz\".");
}

void describe_surface(BodyDef& body, Schema& s) {
  s.add("friction", body.friction, "Coulomb's coefficient; physics.default_friction where it is not given.").at_least(0);
  s.add("restitution", body.restitution,
        "Speed after a hit over speed before; above 1 adds energy. physics.default_restitution where it is not given.")
      .at_least(0);
  s.add("rolling_friction", body.rolling_friction,
        "What stops a round body that rolls: a force at its rim of so many times what presses; on a slope steeper than this it "
        "rolls. 0.002 is a steel ball on steel, 0.03 a ball on grass. Of two bodies the larger counts.")
      .at_least(0);
  s.add("spinning_friction", body.spinning_friction,
        "The same for a round body that spins on the spot: a moment of so many times its radius times what presses.")
      .at_least(0);
  s.add("friction_combine", body.friction_combine,
        "How the frictions of two bodies become one. Where two bodies differ: multiply before average, before min, before max "
        "(the later one wins). The world's rule where neither says.");
  s.add("restitution_combine", body.restitution_combine, "The same for restitution.");
  s.add("surface_velocity", body.surface_velocity, "Of its surface against itself, in its own frame, as of a conveyor belt, m/s.");
}

void check_letters(const char* field, const std::string& letters) {
  const auto bad = letters.find_first_not_of("xyz");
  if (bad != std::string::npos)
    fail(field, " takes the letters x, y and z (got '", letters, "'); leave it empty to lock nothing");
}

// Whatever has mass somewhere has no moment above the sum of the other two.
void check_inertia(Vec3 i) {
  const auto text = [&] { return number_text(i.x) + ", " + number_text(i.y) + ", " + number_text(i.z); };
  if (!(i.x > 0 && i.y > 0 && i.z > 0)) fail("inertia takes three moments above 0 (got ", text(), "); rotation_factor and lock_rotation keep a body from turning");
  const double most = std::max({i.x, i.y, i.z});
  if (2 * most > (i.x + i.y + i.z) * (1 + 1e-9))
    fail("inertia: no moment can be above the sum of the other two (got ", text(), "); a flat disc has m r^2 / 2 about its axis and m r^2 / 4 across");
}

}  // namespace

void describe(BodyDef& body, Schema& s) {
  s.name("body", "Makes a node a rigid body.");
  s.main("type");
  s.add("type", body.type, "\"dynamic\" obeys forces, \"static\" never moves, \"kinematic\" is moved by you and pushes dynamic ones.");
  s.add("fit", body.fit, "Where no colliders are given: fitted to the \"mesh\", or a box of the \"node\"'s scale.");
  s.add("mass", body.mass, "Mass, kg; 1 where neither mass nor density is given.").above(0);
  s.add("density", body.density, "Instead of a mass, kg/m^3.").above(0);
  s.add("center_of_mass", body.center_of_mass, "In the body's frame, m; by its colliders where it is not given.");
  s.add("inertia", body.inertia,
        "Moments of inertia about the body's own axes through its centre of mass, kg m^2; by its colliders where they are not given. "
        "A thin hollow ball has 2/3 m r^2 about each.");
  describe_motion(body, s);
  describe_surface(body, s);
  s.add("group", body.group, "A name from physics.groups; empty is the default group.");
  s.add("collides_with", body.collides_with,
        "Names of the groups it meets; empty: all. \"default\" is the default group. Two bodies meet if both agree.");
  s.add("trigger", body.trigger, "Reports what is in it and lets everything through.");
  s.add("continuous", body.continuous, "Met ahead on its whole way in a tick, so that it cannot pass through thin things, which is so where it is not given; false: only within its own size.");
  s.add("can_sleep", body.can_sleep, "May it fall asleep where it rests?");
  s.add("colliders", body.colliders, "Its shapes; fitted where none is given.");
  s.check<BodyDef>([](const BodyDef& def) {
    check_letters("lock_position", def.lock_position);
    check_letters("lock_rotation", def.lock_rotation);
    if (def.inertia) check_inertia(*def.inertia);
    if (def.mass && def.density) fail("mass and density are given both; leave one of them out");
  });
}

}  // namespace tumble
