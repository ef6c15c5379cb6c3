// The world's settings and figures.
#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

template <class Change>
void change_settings(Script& s, Change change) {
  change(s.settings().physics);
  s.engine().configure_physics(s.settings().physics);
}
Vec3 gravity(Script& s) { return s.settings().physics.gravity; }
void set_gravity(Script& s, Vec3 v) {
  change_settings(s, [&](WorldSettings& w) { w.gravity = v; });
}
bool sleeping(Script& s) { return s.settings().physics.sleeping; }
void set_sleeping(Script& s, bool on) {
  change_settings(s, [&](WorldSettings& w) { w.sleeping = on; });
}
std::string profile(Script& s) { return enum_names(Profile{})[static_cast<std::size_t>(s.settings().physics.profile)]; }
void set_profile(Script& s, std::string name) {
  change_settings(s, [&](WorldSettings& w) { assign(type_of<Profile>(), &w.profile, Value(name), "physics.profile"); });
}
std::optional<int> substeps(Script& s) { return s.settings().physics.substeps; }
void set_substeps(Script& s, std::optional<int> n) {
  if (n && (*n < 1 || *n > 64)) fail("physics.substeps: 1 to 64 expected, or nil for what the profile says, got ", *n);
  change_settings(s, [&](WorldSettings& w) { w.substeps = n; });
}
int iterations(Script& s) { return s.settings().physics.iterations; }
void set_iterations(Script& s, int n) {
  if (n < 1 || n > 1000) fail("physics.iterations: 1 to 1000 expected, got ", n);
  change_settings(s, [&](WorldSettings& w) { w.iterations = n; });
}
int threads(Script& s) { return s.settings().physics.threads; }
void set_threads(Script& s, int n) {
  if (n < 1 || n > 16) fail("physics.threads: 1 to 16 expected, got ", n);
  change_settings(s, [&](WorldSettings& w) { w.threads = n; });
}
double default_friction(Script& s) { return s.settings().physics.default_friction; }
void set_default_friction(Script& s, double v) {
  if (v < 0) fail("physics.default_friction: 0 or more expected, got ", number_text(v));
  change_settings(s, [&](WorldSettings& w) { w.default_friction = v; });
}
double default_restitution(Script& s) { return s.settings().physics.default_restitution; }
void set_default_restitution(Script& s, double v) {
  if (v < 0) fail("physics.default_restitution: 0 or more expected, got ", number_text(v));
  change_settings(s, [&](WorldSettings& w) { w.default_restitution = v; });
}
std::string debug_view(Script& s) { return enum_names(DebugView{})[static_cast<std::size_t>(s.settings().debug_view)]; }
void set_debug_view(Script& s, std::string name) {
  assign(type_of<DebugView>(), &s.settings().debug_view, Value(name), "physics.debug_view");
}
Value stats(Script& s) {
  const WorldStats stats = s.engine().world() ? s.engine().world()->stats() : WorldStats{};
  return Map{{"bodies", stats.bodies}, {"awake", stats.awake}, {"joints", stats.joints}, {"contacts", stats.contacts},
             {"islands", stats.islands}, {"substeps", stats.substeps}, {"step_ms", stats.step_ms}};
}

}  // namespace

void rows_physics_settings(Area& a) {
  a.fn<stats>("stats", "Figures of the last step: bodies, awake, joints, contacts, islands (what touches or is joined), substeps (the most that one of them took), step_ms.").queries().gives("table");
  a.prop<gravity, set_gravity>("gravity", "Acceleration of free fall, m/s^2.");
  a.prop<sleeping, set_sleeping>("sleeping", "May bodies at rest fall asleep?");
  a.prop<profile, set_profile>("profile", "What accuracy may cost: \"fast\", \"balanced\" or \"exact\" take 2, 4 or 16 substeps at least.");
  a.prop<substeps, set_substeps>("substeps", "How many small steps make a tick, at least, in place of the profile's; nil: as the profile says.");
  a.prop<iterations, set_iterations>("iterations", "How often, at least, the solver goes over the contacts in each half of a substep; a blow takes more.");
  a.prop<threads, set_threads>("threads", "How many threads a tick's physics may use, at most; more than the machine has are not taken. Nothing but its time depends on it.");
  a.prop<default_friction, set_default_friction>("default_friction", "Friction of a body that gives none.");
  a.prop<default_restitution, set_default_restitution>("default_restitution", "Restitution of a body that gives none.");
  a.prop<debug_view, set_debug_view>("debug_view", "What F3 steps through: none, colliders, joints, boxes, contacts, rays, velocities, names, or physics: all but boxes and names.");
}

}  // namespace tumble
