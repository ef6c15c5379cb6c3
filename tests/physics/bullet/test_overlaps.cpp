// Pairs whose boxes overlap: against a look at all pairs, whatever came, went and moved.
#include "physics/bullet/overlaps.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <set>

#include "physics/bullet/pair_configuration.h"

using namespace tumble;

namespace {

struct Crowd {
  static constexpr int kCount = 60;
  PairConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  Overlaps overlaps{dispatcher};
  std::vector<std::unique_ptr<BodyState>> bodies;
  std::mt19937 random{11};

  Crowd() {
    for (int i = 0; i < kCount; ++i) {
      auto body = std::make_unique<BodyState>();
      body->def.type = i % 3 == 0 ? BodyType::fixed : BodyType::dynamic;
      body->def.colliders.emplace_back();
      body->serial = static_cast<std::uint32_t>(i + 1);
      build(*body, {});
      body->solid_box = {body.get(), body->rigid.get(), false, false, nullptr, {}};
      body->trigger_box.body = body.get();
      bodies.push_back(std::move(body));
    }
  }
  ~Crowd() {
    for (auto& body : bodies) overlaps.leave(body->solid_box);
  }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  BodyState& any() { return *bodies[static_cast<std::size_t>(random() % kCount)]; }
  void put(BodyState& body) {
    const btVector3 at(between(0, 10), between(0, 10), between(0, 10)), half(between(0.1, 2), between(0.1, 2), between(0.1, 2));
    overlaps.set_box(body.solid_box, btDbvtVolume::FromCE(at, half));
  }
  void set_active(BodyState& body, bool active) {
    body.active = active && body.dynamic();
    if (body.active) overlaps.stir(body);
    else overlaps.settle(body);
  }
};

using Names = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

Names by_force(const Crowd& crowd, bool active_only) {
  Names pairs;
  for (const auto& a : crowd.bodies)
    for (const auto& b : crowd.bodies) {
      if (a->serial >= b->serial || !a->solid_box.leaf || !b->solid_box.leaf || (!a->dynamic() && !b->dynamic())) continue;
      if (active_only && !a->active && !b->active) continue;
      const btDbvtVolume &x = a->solid_box.box(), &y = b->solid_box.box();
      bool meet = true;
      for (int i = 0; i < 3; ++i) meet = meet && x.Mins()[i] <= y.Maxs()[i] && y.Mins()[i] <= x.Maxs()[i];
      if (meet) pairs.emplace(a->serial, b->serial);
    }
  return pairs;
}

}  // namespace

TEST_CASE("overlaps: there is a pair exactly where two boxes overlap, and it is active where a side is", "[physics]") {
  Crowd crowd;
  std::size_t most = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    BodyState& body = crowd.any();
    switch (crowd.random() % 8) {
      case 0: crowd.overlaps.leave(body.solid_box); break;
      case 1: crowd.overlaps.renew(body.solid_box); break;
      case 2: crowd.set_active(body, true); break;
      case 3: crowd.set_active(body, false); break;
      default: crowd.put(body);
    }
    if (turn % 10 != 0) continue;
    Names pairs, active;
    crowd.overlaps.each([&](const Overlap& overlap) { pairs.emplace(overlap.a->body->serial, overlap.b->body->serial); });
    for (const Overlap* overlap : crowd.overlaps.active(Overlap::bodies)) active.emplace(overlap->a->body->serial, overlap->b->body->serial);
    REQUIRE(pairs == by_force(crowd, false));
    REQUIRE(active == by_force(crowd, true));
    most = std::max(most, active.size());
  }
  CHECK(most > 50);
}
