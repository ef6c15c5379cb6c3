// What a rigid body and its colliders are made of, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/describe.h"
#include "base/handle.h"
#include "base/shape.h"

namespace tumble {

struct Body;   // the world's own
struct Joint;  // the world's own
using BodyId = Handle<Body>;
using JointId = Handle<Joint>;

enum class BodyType { dynamic, fixed, kinematic };  // "dynamic", "static", "kinematic" ('static' is a C++ keyword)
enum class Combine { average, min, max, multiply };
const EnumNames& enum_names(BodyType);
const EnumNames& enum_names(Combine);

// One shape of a body. What it leaves open holds as the body says. A mesh or height_field takes its triangles from
// `points`, three each, and works on static and kinematic bodies; a plane is a box of up to 0.1 m below its surface.
struct ColliderDef {
  Shape shape;                        // its fields are the collider's own fields: { shape = "box", size = ... }
  Vec3 offset;                        // in the body's frame, m
  Quat rotation;
  std::optional<double> friction, restitution, density;
  std::optional<bool> trigger;
  std::string name;
};
void describe(ColliderDef& collider, Schema& s);

enum class Fit { mesh, node };
const EnumNames& enum_names(Fit);

struct BodyDef {
  BodyType type = BodyType::dynamic;
  Fit fit = Fit::mesh;                // where no colliders are given: fitted to the mesh, or to the node's scale as a box
  std::optional<double> mass;         // kg; 1 where neither mass nor density is given
  std::optional<double> density;      // kg/m^3
  std::optional<Vec3> center_of_mass; // in the body's frame, m; by the colliders where it is not given
  std::optional<Vec3> inertia;        // kg m^2, about the body's own axes through its centre of mass; likewise
  Vec3 velocity, angular_velocity;    // world, m/s and rad/s
  std::optional<double> friction, restitution;  // the world's defaults where not given
  std::optional<Combine> friction_combine, restitution_combine;
  double rolling_friction = 0, spinning_friction = 0;  // moments over what presses, in radii; the larger of two bodies'
  double damping = 0, angular_damping = 0;      // 1/s: v(t) = v0 exp(-damping t)
  double gravity_factor = 1;
  Vec3 rotation_factor{1, 1, 1};      // world axes; 0 locks
  std::string lock_position, lock_rotation;     // letters of the world axes that are locked: "z", "xyz"
  std::string group;                  // "" is the default group
  std::vector<std::string> collides_with;       // empty: with every group
  bool trigger = false;
  std::optional<bool> continuous;     // not given: by speed
  bool can_sleep = true;
  Vec3 surface_velocity;              // of its surface against itself, in its own frame, as of a conveyor belt, m/s
  std::vector<ColliderDef> colliders;
};
void describe(BodyDef& body, Schema& s);

struct MassProperties {
  double mass = 0;         // kg; 0 of a static or kinematic body
  Vec3 center;             // centre of mass in the body's frame, m
  Vec3 inertia;            // principal moments, kg m^2
  Quat axes;               // turns principal axes to the body's axes
};
// Exact for every shape but mesh and height_field, which have none. Triggers count only where nothing else is there.
MassProperties mass_properties(const BodyDef& body);

}  // namespace tumble
