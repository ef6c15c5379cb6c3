#include "render/gl/mesh_pass.h"

#include <string>

namespace tumble {
namespace {

constexpr int kPictureUnit = 0, kShadowUnit = 1;
// A second shadow map is drawn where it is at least so much sharper.
constexpr double kSharper = 2;
// What is round may be thinner by this much in a shadow map, texels: the edges of shadows are soft over more than two.
constexpr double kThinner = 0.5;

// Features of a form of the mesh shader.
constexpr int kTexture = 1, kHoles = 2, kBlend = 4, kFog = 8, kLamps = 16, kShadow = 32;

std::string defines_of(int features, const Quality& quality) {
  std::string text;
  const auto define = [&](int feature, const char* name, int value) {
    if (features & feature) text += std::string("#define ") + name + " " + std::to_string(value) + "\n";
  };
  define(kTexture, "TEXTURE", 1);
  define(kHoles, "HOLES", 1);
  define(kBlend, "BLEND", 1);
  define(kFog, "FOG", 1);
  define(kLamps, "LAMPS", quality.lamps);
  if (features >= kShadow) text += "#define SHADOW " + std::to_string(features / kShadow) + "\n";
  return text + "#define SHADOW_TAPS " + std::to_string(quality.shadow_taps) + "\n";
}

}  // namespace

void set_air(const Program& program, const Air& air) {
  program.set("sky_top", air.sky_top);
  program.set("sky_horizon", air.sky_horizon);
  program.set("ground_color", air.ground);
  program.set("to_sun", air.to_sun);
  program.set("sun_light", air.sun);
  program.set("fog_color", air.fog_color);
  program.set("fog", air.fog);
  program.set("haze", air.haze);
}

MeshPass::MeshPass(const Gl& gl, const Quality& quality)
    : gl_(gl), quality_(quality), shadow_program_(gl, {"shadow.vert.glsl"}, {"shadow.frag.glsl"}), meshes_(gl) {}

ShadowMap& MeshPass::map_for(const PictureState& state) {
  std::unique_ptr<ShadowMap>& map = shadow_maps_[state.shadows.size() - 1];
  if (!map) map = std::make_unique<ShadowMap>(gl_, quality_.shadow_map_size, static_cast<int>(state.shadows.size()));
  return *map;
}

void MeshPass::draw_shadows(PictureState& state, const std::vector<MeshBox>& boxes) {
  const DrawList& list = state.list;
  if (!list.has_sun || !list.sun_shadow || list.sun_brightness <= 0) return;
  const SunView sun(list, boxes);
  const int size = quality_.shadow_map_size;
  const ShadowFit wide = sun.fit(state.aspect, size);
  if (!wide.any) return;
  const ShadowFit sharp = sun.fit(state.aspect, size, near_shadow_distance(state.around, state.frustum));
  if (sharp.any && sharp.texel * kSharper < wide.texel) state.shadows.push_back(sharp);
  state.shadows.push_back(wide);

  ShadowMap& map = map_for(state);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Disable(GL_BLEND);
  gl_.Enable(GL_CULL_FACE);
  map.begin();
  // Steep faces lie up to a texel deeper at a texel's far edge; the rest is done along the normal (mesh.frag.glsl).
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1.5f, 2.0f);
  shadow_program_.use();
  for (std::size_t i = 0; i < state.shadows.size(); ++i) {
    const ShadowFit& fit = state.shadows[i];
    const Batches casters = make_casters(list, state.around, kThinner * fit.texel, [&](const Ball& ball) {
      return fit.may_hold(ball) && fit.may_shade(ball, state.frustum);
    });
    meshes_.upload(casters);
    map.use_map(static_cast<int>(i));
    shadow_program_.set("matrix", fit.matrix);
    for (const Batch& batch : casters.opaque) {
      if (batch.two_sided) gl_.Disable(GL_CULL_FACE);
      meshes_.draw(list, batch);
      if (batch.two_sided) gl_.Enable(GL_CULL_FACE);
    }
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

const Program& MeshPass::program_for(const PictureState& state, const Textures::Entry* texture, bool blend) {
  int features = kShadow * static_cast<int>(state.shadows.size());
  if (texture) features |= kTexture;
  if (texture && texture->has_holes && !blend) features |= kHoles;
  if (blend) features |= kBlend;
  if (state.air.has_fog) features |= kFog;
  if (!state.lamps.place.empty()) features |= kLamps;
  std::unique_ptr<Program>& program = programs_[features];
  if (!program)
    program = std::make_unique<Program>(gl_, std::initializer_list<const char*>{"mesh.vert.glsl"},
                                        std::initializer_list<const char*>{"srgb.glsl", "air.glsl", "mesh.frag.glsl"},
                                        defines_of(features, quality_));
  return *program;
}

void MeshPass::set_picture(const Program& program, const PictureState& state) const {
  set_air(program, state.air);
  program.set("matrix", state.camera);
  program.set("light_above", state.air.above);
  program.set("light_below", state.air.below);
  program.set("exposure", state.list.exposure);
  program.set("picture", kPictureUnit);
  program.set("lamp_count", static_cast<int>(state.lamps.place.size()));
  program.set("lamp_place", state.lamps.place);
  program.set("lamp_light", state.lamps.light);
  program.set("lamp_axis", state.lamps.axis);
  if (state.shadows.empty()) return;
  const ShadowFit& first = state.shadows.front();
  const ShadowFit& last = state.shadows.back();
  program.set("shadow_map", kShadowUnit);
  program.set("shadow_matrix", first.to_map);
  program.set("shadow_texel", first.texel);
  program.set("far_shadow_matrix", last.to_map);
  program.set("far_shadow_texel", last.texel);
  const double step = 1.0 / quality_.shadow_map_size;
  program.set("shadow_step", step / static_cast<double>(state.shadows.size()), step);
  program.set("shadow_distance", kShadowDistance);
}

void MeshPass::draw(const PictureState& state, Textures& textures, const std::vector<Batch>& batches, bool blend) {
  if (!state.shadows.empty()) map_for(state).bind(kShadowUnit);
  const Program* used = nullptr;
  for (const Batch& batch : batches) {
    const Textures::Entry* texture = batch.texture > 0 ? &textures.find(state.list.textures[batch.texture]) : nullptr;
    const Program& program = program_for(state, texture, blend);
    if (&program != used) {
      program.use();
      set_picture(program, state);
      used = &program;
    }
    if (texture) textures.bind(texture->texture, kPictureUnit, batch.again);
    if (batch.two_sided) gl_.Disable(GL_CULL_FACE);
    meshes_.draw(state.list, batch);
    if (batch.two_sided) gl_.Enable(GL_CULL_FACE);
  }
}

}  // namespace tumble
