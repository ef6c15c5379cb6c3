// Our own World behind the suite's interface.
#include <algorithm>

#include "accuracy/engines/engines.h"
#include "base/fixed_clock.h"
#include "physics/world.h"

namespace tumble::accuracy {

namespace {

class TumbleSimulation final : public Simulation {
 public:
  TumbleSimulation(const SceneSettings& settings, const Knobs& knobs) : world_(world_settings(settings, knobs)), clock_(kTick, settings.most_ticks) {}

  BodyIndex add(const BodyDef& body, const Pose& pose) override {
    const BodyIndex index = static_cast<BodyIndex>(bodies_.size());
    know_groups(body);
    bodies_.push_back(world_.add(body, pose, static_cast<std::uint64_t>(index)));
    triggers_.push_back(is_trigger(body));
    return index;
  }
  JointIndex add(const JointSpec& joint) override {
    JointDef def = joint.def;
    def.a = joint.a == kWorld ? BodyId{} : id(joint.a);
    def.b = joint.b == kWorld ? BodyId{} : id(joint.b);
    joints_.push_back(world_.add(def, joints_.size()));
    return static_cast<JointIndex>(joints_.size()) - 1;
  }
  void remove(BodyIndex body) override { world_.remove(id(body)); }
  void remove_joint(JointIndex joint) override { world_.remove(joint_id(joint)); }
  void configure(BodyIndex body, const BodyDef& def) override {
    BodyDef next = def;
    next.velocity = world_.velocity(id(body));
    next.angular_velocity = world_.angular_velocity(id(body));
    know_groups(def);
    world_.configure(id(body), next);
    triggers_[static_cast<std::size_t>(body)] = is_trigger(def);
  }
  void configure_joint(JointIndex joint, const JointDef& def) override {
    JointDef next = def;
    next.a = world_.def(joint_id(joint)).a;
    next.b = world_.def(joint_id(joint)).b;
    world_.configure(joint_id(joint), next);
  }
  void set_enabled(BodyIndex body, bool enabled) override { world_.set_enabled(id(body), enabled); }
  void set_gravity(Vec3 gravity) override {
    WorldSettings settings = world_.settings();
    settings.gravity = gravity;
    world_.configure(settings);
  }

  void teleport(BodyIndex body, const Pose& pose) override { world_.teleport(id(body), pose); }
  void move(BodyIndex body, const Pose& pose) override { world_.move(id(body), pose); }
  void set_velocity(BodyIndex body, Vec3 velocity) override { world_.set_velocity(id(body), velocity); }
  void set_angular_velocity(BodyIndex body, Vec3 velocity) override { world_.set_angular_velocity(id(body), velocity); }
  void apply_force(BodyIndex body, Vec3 force) override { world_.apply_force(id(body), force); }
  void apply_torque(BodyIndex body, Vec3 torque) override { world_.apply_torque(id(body), torque); }
  void apply_impulse(BodyIndex body, Vec3 impulse, std::optional<Vec3> point) override {
    if (point) world_.apply_impulse(id(body), impulse, *point);
    else world_.apply_impulse(id(body), impulse);
  }
  void wake(BodyIndex body) override { world_.wake(id(body)); }
  void step(double seconds) override {
    world_.step(seconds);
    for (const ContactEvent& event : world_.take_events().contacts) {
      if (!event.trigger || event.kind == EventKind::stay) continue;
      const BodyIndex a = static_cast<BodyIndex>(event.user_a), b = static_cast<BodyIndex>(event.user_b);
      const bool first = triggers_[static_cast<std::size_t>(a)];
      crossings_.push_back({first ? a : b, first ? b : a, event.kind == EventKind::enter, event.time});
    }
  }
  // As the app's loop does.
  Frame frame(double seconds) override {
    Frame frame;
    const double dropped = clock_.dropped_seconds();
    clock_.begin_frame(seconds);
    for (; clock_.take_tick(); ++frame.ticks) step(kTick);
    frame.dropped = clock_.dropped_seconds() - dropped;
    return frame;
  }

  Pose pose(BodyIndex body) const override { return world_.pose(id(body)); }
  Vec3 velocity(BodyIndex body) const override { return world_.velocity(id(body)); }
  Vec3 angular_velocity(BodyIndex body) const override { return world_.angular_velocity(id(body)); }
  bool asleep(BodyIndex body) const override { return world_.asleep(id(body)); }
  bool enabled(BodyIndex body) const override { return world_.enabled(id(body)); }
  MassProperties mass_properties(BodyIndex body) const override { return world_.mass_properties(id(body)); }
  JointState joint_state(JointIndex joint) const override { return world_.state(joint_id(joint)); }
  std::vector<Touch> touches() const override {
    std::vector<Touch> touches;
    world_.each_contact([&](const ContactEvent& contact) {
      touches.push_back({static_cast<BodyIndex>(contact.user_a), static_cast<BodyIndex>(contact.user_b), contact.point, contact.normal,
                         contact.impulse, static_cast<int>(contact.points.size())});
    });
    return touches;
  }
  std::vector<Crossing> take_crossings() override { return std::exchange(crossings_, {}); }
  std::optional<RayHit> raycast(Vec3 origin, Vec3 direction, double length) const override { return hit(world_.raycast(origin, direction, length)); }
  std::optional<RayHit> cast(const Shape& shape, const Pose& from, Vec3 direction, double length) const override {
    return hit(world_.cast(shape, from, direction, length));
  }
  int contact_points() const override { return world_.stats().contacts; }

 private:
  static constexpr double kTick = 1.0 / 60;

  static WorldSettings world_settings(const SceneSettings& settings, const Knobs& knobs) {
    WorldSettings out;
    out.gravity = settings.gravity;
    out.sleeping = settings.sleeping;
    out.threads = settings.threads;
    out.substeps = knobs.substeps;
    out.iterations = knobs.iterations;
    out.friction_combine = out.restitution_combine = Combine::multiply;
    return out;
  }
  // A game lists its groups; a case just names them.
  void know_groups(const BodyDef& body) {
    std::vector<std::string> names = body.collides_with;
    names.push_back(body.group);
    WorldSettings settings = world_.settings();
    const std::size_t before = settings.groups.size();
    for (const std::string& name : names)
      if (!name.empty() && std::find(settings.groups.begin(), settings.groups.end(), name) == settings.groups.end()) settings.groups.push_back(name);
    if (settings.groups.size() > before) world_.configure(settings);
  }
  static bool is_trigger(const BodyDef& body) {
    return body.trigger || (!body.colliders.empty() && body.colliders.front().trigger.value_or(false));
  }
  BodyId id(BodyIndex body) const { return bodies_.at(static_cast<std::size_t>(body)); }
  JointId joint_id(JointIndex joint) const { return joints_.at(static_cast<std::size_t>(joint)); }
  std::optional<RayHit> hit(const std::optional<QueryHit>& found) const {
    if (!found) return {};
    return RayHit{static_cast<BodyIndex>(world_.user(found->body)), found->point, found->normal, found->distance};
  }

  World world_;
  FixedClock clock_;
  std::vector<BodyId> bodies_;
  std::vector<bool> triggers_;
  std::vector<JointId> joints_;
  std::vector<Crossing> crossings_;
};

}  // namespace

std::unique_ptr<Simulation> make_tumble(const SceneSettings& settings, const Knobs& knobs) { return std::make_unique<TumbleSimulation>(settings, knobs); }

const std::vector<EngineKind>& engines() {
  static const std::vector<EngineKind> kinds = {{"tumble", {4, 2}, make_tumble}, {"stock", {1, 10}, make_stock}};
  return kinds;
}

}  // namespace tumble::accuracy
