#include "engine/particles.h"

#include <algorithm>

#include "render/draw_list.h"

namespace tumble {

namespace {

// Uniform over the cap of the unit sphere within `spread` of up: the height above its rim is (Archimedes).
Vec3 direction_in_cone(double spread, Random& random) {
  const double y = 1 - random.unit() * (1 - std::cos(spread));
  const double around = 2 * kPi * random.unit(), r = std::sqrt(std::max(0.0, 1 - y * y));
  return {r * std::cos(around), y, r * std::sin(around)};
}

bool is_shown(const Scene& scene, NodeId id) {
  for (; id; id = scene[id].parent) {
    const SceneNode& node = scene[id];
    if (node.dying || !node.visible || !node.enabled) return false;
  }
  return true;
}

Color blend(const Color& a, const Color& b, double t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, a.a + (b.a - a.a) * t};
}

}  // namespace

// x'' = pull - k x': the speed nears pull / k as exp(-k t).
Vec3 place_of(const Particle& p, double age) {
  const double k = p.damping;
  if (k * age < 1e-6) return p.position + p.velocity * age + p.pull * (age * age / 2);
  const Vec3 last = p.pull / k;
  return p.position + last * age + (p.velocity - last) * (-std::expm1(-k * age) / k);
}

void ParticleField::clear() {
  groups_.clear();
  count_ = 0;
}

void ParticleField::step(const Scene& scene, Vec3 gravity, double seconds, const LogSink& log) {
  if (!drawn_ || (emitters_.empty() && groups_.empty())) return;
  now_ += seconds;
  step_seconds_ = seconds;
  drop_dead();
  std::erase_if(emitters_, [&](NodeId node) { return !scene.get(node) || !scene[node].particles; });
  for (const NodeId node : emitters_)
    if (scene[node].particles->playing && is_shown(scene, node)) emit(scene, node, groups_[node], gravity, log);
}

void ParticleField::emit(const Scene& scene, NodeId node, Group& group, Vec3 gravity, const LogSink& log) {
  const Particles& look = *scene[node].particles;
  const double before = group.due;
  group.due += look.rate * step_seconds_;
  for (int i = 1; group.due >= 1; ++i, group.due -= 1) {
    const double alpha = std::clamp((i - before) / (look.rate * step_seconds_), 0.0, 1.0);
    const double birth = now_ - (1 - alpha) * step_seconds_;
    if (add(group, look, scene.interpolated_world(node, alpha), birth, gravity)) continue;
    group.due = 0;
    return say_full(scene, node, log);
  }
}

void ParticleField::burst(const Scene& scene, NodeId node, int count, Vec3 gravity, const LogSink& log) {
  if (!drawn_ || !is_shown(scene, node)) return;
  const Particles& look = *scene[node].particles;
  Group& group = groups_[node];
  for (int i = 0; i < count; ++i)
    if (!add(group, look, scene.world(node), now_, gravity)) return say_full(scene, node, log);
}

bool ParticleField::add(Group& group, const Particles& look, const Transform& place, double birth, Vec3 gravity) {
  if (count_ >= kMost) return false;
  const auto less = [&] { return 1 - look.variation * random_.unit(); };
  const Vec3 start{random_.unit() - 0.5, random_.unit() - 0.5, random_.unit() - 0.5};
  Particle particle;
  particle.birth = birth;
  particle.life = look.life * less();
  particle.position = to_parent(place, scaled(look.area, start));
  particle.velocity = place.rotation * direction_in_cone(look.spread, random_) * (look.speed * less());
  particle.pull = gravity * look.gravity_factor;
  particle.damping = look.damping;
  const double size = less();
  particle.size = look.size * size;
  particle.size_end = look.size_end * size;
  particle.color = look.color;
  particle.color_end = look.color_end.value_or(Color{look.color.r, look.color.g, look.color.b, 0});
  particle.glow = look.glow;
  group.texture = look.texture;
  group.particles.push_back(particle);
  ++count_;
  return true;
}

void ParticleField::say_full(const Scene& scene, NodeId node, const LogSink& log) const {
  if (!log) return;
  log({LogLevel::warning, "particles: " + std::to_string(kMost) + " are alive, which is the most that a game may have; '" + scene.path(node) +
                              "' and others wait until some end. Give a lower rate or a shorter life"});
}

// A particle is kept until it is dead in the picture of the last tick too.
void ParticleField::drop_dead() {
  count_ = 0;
  for (auto group = groups_.begin(); group != groups_.end();) {
    std::erase_if(group->second.particles, [this](const Particle& p) { return p.birth + p.life <= now_ - step_seconds_; });
    count_ += group->second.particles.size();
    if (group->second.particles.empty() && !emitters_.contains(group->first)) group = groups_.erase(group);
    else ++group;
  }
}

void ParticleField::draw(double alpha, Vec3 origin, std::vector<DrawParticles>& out) const {
  const double time = now_ - (1 - alpha) * step_seconds_;
  for (const auto& [node, group] : groups_) {
    DrawParticles drawn;
    drawn.texture = group.texture;
    for (const Particle& particle : group.particles) {
      const double age = time - particle.birth;
      if (age < 0 || age >= particle.life) continue;
      const double t = age / particle.life;
      const Vec3 place = place_of(particle, age) - origin;
      DrawParticle& sprite = drawn.particles.emplace_back();
      sprite.position = {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)};
      sprite.size = static_cast<float>(particle.size + (particle.size_end - particle.size) * t);
      sprite.color = blend(particle.color, particle.color_end, t);
      sprite.glow = static_cast<float>(particle.glow);
    }
    if (!drawn.particles.empty()) out.push_back(std::move(drawn));
  }
}

}  // namespace tumble
