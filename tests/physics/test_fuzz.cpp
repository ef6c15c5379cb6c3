// Random worlds: bodies of all kinds in one another, joints, removals, scalings, blows. Nothing may crash, nothing may
// become a number that is none. TUMBLE_FUZZ=100000 plays that many of them, TUMBLE_FUZZ_FIRST=50001 leaves out those before.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <random>

#include "base/error.h"
#include "physics/physical.h"

using namespace tumble;

namespace {

class Fuzz {
 public:
  explicit Fuzz(std::uint64_t seed) : random_(seed) {
    WorldSettings settings;
    settings.gravity = one_in(4) ? Vec3{} : Vec3{0, -9.81, 0};
    settings.substeps = static_cast<int>(1 + index(6));
    settings.sleeping = !one_in(3);
    world_ = std::make_unique<World>(settings);
    if (!one_in(5)) ids_.push_back(world_->add(body(box({40, 1, 40}), BodyType::fixed), {{0, -0.5, 0}, {}}, 0));
    for (std::size_t i = 0, count = 1 + index(10); i < count; ++i) add();
    for (std::size_t i = 0, count = index(6); i < count; ++i) join();
  }

  void play() {
    for (std::size_t i = 0, count = 1 + index(20); i < count; ++i) {
      if (one_in(3)) act();
      world_->step(one_in(10) ? number(1e-4, 0.3) : 1.0 / 60);
      world_->take_events();
      for (const BodyId id : ids_) {
        const Pose pose = world_->pose(id);
        INFO("a body of kind " << static_cast<int>(world_->def(id).type) << ", mass " << world_->mass_properties(id).mass << ", enabled " << world_->enabled(id) << ", after step " << i);
        REQUIRE(is_finite(pose.position));
        REQUIRE(is_finite(pose.rotation));
        REQUIRE(is_finite(world_->velocity(id)));
        REQUIRE(is_finite(world_->angular_velocity(id)));
      }
    }
  }

 private:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t index(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  bool one_in(int n) { return index(static_cast<std::size_t>(n)) == 0; }
  Vec3 place(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Quat turn() { return normalized(Quat{number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)}); }
  // From a grain to a house, seldom.
  double size() { return one_in(8) ? std::pow(10.0, number(-3, 2)) : number(0.2, 1.5); }

  Shape shape() {
    Shape s;
    constexpr ShapeKind kinds[] = {ShapeKind::box, ShapeKind::sphere, ShapeKind::capsule, ShapeKind::cylinder, ShapeKind::cone, ShapeKind::pyramid, ShapeKind::hull};
    s.shape = kinds[index(std::size(kinds))];
    s.size = {size(), size(), size()};
    s.radius = size() / 2;
    s.height = size() + (s.shape == ShapeKind::capsule ? 2 * s.radius : 0);
    for (int i = 0; i < 12; ++i) s.points.push_back(place(0.5));
    return s;
  }

  void add() {
    BodyDef def = body(shape(), one_in(8) ? BodyType::kinematic : one_in(8) ? BodyType::fixed : BodyType::dynamic);
    if (one_in(4)) {  // a compound
      def.colliders.push_back({shape(), place(1), turn(), {}, {}, {}, {}, {}});
      if (one_in(3)) def.colliders.back().trigger = true;
    }
    def.mass = one_in(6) ? std::pow(10.0, number(-3, 5)) : number(0.2, 3);
    def.friction = number(0, 1.5);
    def.restitution = one_in(2) ? 0 : number(0, 1);
    if (one_in(6)) def.rolling_friction = number(0, 0.5);
    if (one_in(6)) def.spinning_friction = number(0, 0.5);
    if (one_in(10)) def.surface_velocity = place(3);
    def.velocity = place(one_in(6) ? 300 : 3);
    def.angular_velocity = place(one_in(6) ? 300 : 3);
    def.lock_rotation = one_in(10) ? "xz" : "";
    def.lock_position = one_in(10) ? "z" : "";
    ids_.push_back(world_->add(def, {place(2) + Vec3{0, 1, 0}, turn()}, 0));
  }

  void join() {
    JointDef def;
    def.a = ids_[index(ids_.size())];
    const BodyId other = ids_[index(ids_.size())];
    if (!(other == def.a) && !one_in(4)) def.b = other;
    def.anchor = place(1);
    def.axis = place(1) + Vec3{0, 1e-3, 0};
    def.collide_connected = one_in(3);
    if (one_in(4)) def.break_force = number(1, 1000);
    def.kind = joint_kind(joint_kind_names()[index(joint_kind_names().size())]);
    if (auto* hinge = std::get_if<HingeDef>(&def.kind); hinge && one_in(2)) {
      hinge->angle.min = -number(0, 1);
      hinge->angle.max = number(0, 1);
      hinge->angle.motor.emplace().speed = number(-20, 20);
    }
    if (auto* slider = std::get_if<SliderDef>(&def.kind); slider && one_in(2)) {
      slider->position.spring.emplace().frequency = std::pow(10.0, number(-1, 3));
      slider->position.max = number(0, 1);
      if (one_in(2)) slider->position.motor.emplace().speed = number(-5, 5);
      if (one_in(2)) slider->position.friction = number(0, 50);
    }
    joints_.push_back(world_->add(def, 0));
  }

  void act() {
    const std::size_t at = index(ids_.size());
    const BodyId id = ids_[at];
    switch (index(12)) {
      case 0: world_->apply_impulse(id, place(one_in(5) ? 1e6 : 5)); break;
      case 1: world_->apply_force(id, place(one_in(5) ? 1e9 : 50), place(1)); break;
      case 2: world_->set_velocity(id, place(one_in(5) ? 1e4 : 10)); break;
      case 3: world_->set_angular_velocity(id, place(one_in(5) ? 1e4 : 10)); break;
      case 4: world_->teleport(id, {place(2), turn()}); break;
      case 5: world_->move(id, {place(2), turn()}); break;
      case 6: {
        BodyDef def = world_->def(id);
        for (ColliderDef& collider : def.colliders) collider.shape = scaled(collider.shape, Vec3{1, 1, 1} * number(0.3, 2));
        world_->configure(id, def);
        break;
      }
      case 7: world_->set_enabled(id, !world_->enabled(id)); break;
      case 8: world_->sleep(id); break;
      case 9: {
        WorldSettings settings = world_->settings();
        settings.gravity = place(15);
        settings.profile = static_cast<Profile>(index(3));
        if (one_in(2)) settings.substeps.reset();
        world_->configure(settings);
        break;
      }
      case 10:
        if (joints_.empty() || one_in(2)) return join();
        if (const JointId joint = joints_[index(joints_.size())]; world_->has(joint)) world_->remove(joint);
        break;
      case 11:
        world_->remove(id);
        ids_.erase(ids_.begin() + static_cast<long>(at));
        if (ids_.empty()) add();
        break;
    }
  }

  std::mt19937_64 random_;
  std::unique_ptr<World> world_;
  std::vector<BodyId> ids_;
  std::vector<JointId> joints_;
};

}  // namespace

TEST_CASE("fuzz: random worlds stay finite", "[physics][fuzz]") {
  const auto from_environment = [](const char* name, std::uint64_t otherwise) {
    const char* wanted = std::getenv(name);
    return wanted ? std::strtoull(wanted, nullptr, 10) : otherwise;
  };
  const std::uint64_t last = from_environment("TUMBLE_FUZZ", 100);
  for (std::uint64_t seed = from_environment("TUMBLE_FUZZ_FIRST", 1); seed <= last; ++seed) {
    INFO("world " << seed);
    Fuzz(seed).play();
  }
}
