#include "render/gl/particle_pass.h"

#include <algorithm>

#include "render/batches.h"

namespace tumble {
namespace {

constexpr float kGlowAdds = 0.35f;      // share of a glowing particle's light that is added rather than laid over
constexpr float kLargestHalo = 2;       // m, of the ball around what glows; around larger things a disc looks false
constexpr float kHaloReach = 2.4f;      // times that ball
constexpr float kHaloStrength = 0.45f;
constexpr float kHaloAdds = 0.4f;       // before a bright sky light that is only added would be white

float squared(const std::array<float, 4>& place) {
  return place[0] * place[0] + place[1] * place[1] + place[2] * place[2];
}

// Sets one after the other, the farthest first: those of one texture are drawn at once.
std::vector<const DrawParticles*> from_afar(const std::vector<DrawParticles>& sets) {
  std::vector<std::pair<float, const DrawParticles*>> order;
  for (const DrawParticles& set : sets) {
    if (set.particles.empty()) continue;
    float sum = 0;
    for (const DrawParticle& p : set.particles) sum += squared({p.position[0], p.position[1], p.position[2], 0});
    order.emplace_back(sum / static_cast<float>(set.particles.size()), &set);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const DrawParticles*> result;
  for (const auto& [distance, set] : order) result.push_back(set);
  return result;
}

}  // namespace

ParticlePass::ParticlePass(const Gl& gl)
    : gl_(gl), program_(gl, {"particle.vert.glsl"}, {"srgb.glsl", "air.glsl", "particle.frag.glsl"}, "#define FOG 1\n"),
      stream_(gl, {4, 4, 2}, 1) {}

void ParticlePass::collect(const DrawParticles& set, const PictureState& state) {
  sprites_.clear();
  for (const DrawParticle& p : set.particles) {
    const auto& [x, y, z] = p.position;
    if (p.color.a <= 0 || p.size <= 0 || !state.frustum.may_see({x, y, z, p.size})) continue;
    sprites_.push_back({{x, y, z, p.size / 2}, linear(p.color), p.glow, kGlowAdds * std::min(p.glow, 1.0f)});
  }
  std::sort(sprites_.begin(), sprites_.end(),
            [](const Sprite& a, const Sprite& b) { return squared(a.place) > squared(b.place); });
}

void ParticlePass::collect_halos(const PictureState& state) {
  sprites_.clear();
  for (std::size_t i = 0; i < state.list.meshes.size(); ++i) {
    const DrawMesh& mesh = state.list.meshes[i];
    const Ball& ball = state.around[i];
    if (mesh.glow <= 0 || mesh.color.a <= 0 || ball.radius > kLargestHalo) continue;
    const float reach = ball.radius * kHaloReach;
    if (!state.frustum.may_see({ball.x, ball.y, ball.z, reach})) continue;
    std::array<float, 4> color = linear(mesh.glow_color.value_or(mesh.color));
    color[3] = kHaloStrength * std::min(mesh.glow, 1.0f);
    sprites_.push_back({{ball.x, ball.y, ball.z, reach}, color, 1, kHaloAdds});
  }
}

void ParticlePass::draw(const PictureState& state, Textures& textures) {
  program_.use();
  set_air(program_, state.air);
  program_.set("matrix", state.camera);
  program_.set("right", state.list.camera_rotation * Vec3{1, 0, 0});
  program_.set("up", state.list.camera_rotation * Vec3{0, 1, 0});
  program_.set("light_around", (state.air.above + state.air.below) / 2 + state.air.sun / 2);
  program_.set("exposure", state.list.exposure);
  program_.set("picture", 0);
  program_.set("is_picture", 0);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  collect_halos(state);
  draw_sprites();
  for (const DrawParticles* set : from_afar(state.list.particles)) {
    collect(*set, state);
    const bool is_picture = !set->texture.empty();
    program_.set("is_picture", is_picture);
    if (is_picture) textures.bind(textures.find({set->texture, -1}).texture, 0, false);
    draw_sprites();
  }
}

void ParticlePass::draw_sprites() {
  if (sprites_.empty()) return;
  stream_.use(sprites_.data(), sprites_.size() * sizeof(Sprite));
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(sprites_.size()));
}

}  // namespace tumble
