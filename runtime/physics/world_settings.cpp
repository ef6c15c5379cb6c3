#include "physics/world.h"

#include <algorithm>

namespace tumble {

const EnumNames& enum_names(Profile) {
  static const EnumNames names = {"fast", "balanced", "exact"};
  return names;
}

int WorldSettings::least_substeps() const {
  if (substeps) return std::max(1, *substeps);
  return profile == Profile::fast ? 2 : profile == Profile::exact ? 16 : 4;
}

void describe(WorldSettings& settings, Schema& s) {
  s.name("physics", "The physical world.");
  s.add("gravity", settings.gravity, "m/s^2.");
  s.add("profile", settings.profile, "What accuracy may cost: \"fast\", \"balanced\" or \"exact\" take 2, 4 or 16 substeps at least.");
  s.add("substeps", settings.substeps, "Parts of one step, at least, in place of the profile's; what is heavily loaded takes more by itself.").between(1, 64);
  s.add("iterations", settings.iterations, "Rounds over contacts in each half of a substep, at least; a blow takes more.").between(1, 1000);
  s.add("sleeping", settings.sleeping, "May resting bodies fall asleep?");
  s.add("default_friction", settings.default_friction, "Of a body that gives none.").at_least(0);
  s.add("default_restitution", settings.default_restitution, "Of a body that gives none.").at_least(0);
  s.add("friction_combine", settings.friction_combine, "How the frictions of two bodies become one.");
  s.add("restitution_combine", settings.restitution_combine, "The same for restitution.");
  s.add("threads", settings.threads, "That a step may use, at most. Nothing but the time depends on them.").between(1, 16);
  s.add("groups", settings.groups, "Names of collision groups, at most 31.");
  s.check<WorldSettings>([](const WorldSettings& value) {
    if (value.groups.size() > 31) fail("groups holds ", value.groups.size(), " names; 31 at most, join some of them");
  });
}

}  // namespace tumble
