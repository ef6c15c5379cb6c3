#include "platform/window.h"
#include "render/batches.h"
#include "render/gl/functions.h"
#include "render/gl/line_pass.h"
#include "render/gl/meshes.h"
#include "render/gl/program.h"
#include "render/gl/target.h"
#include "render/gl/textures.h"
#include "render/gl/ui_pass.h"
#include "render/view.h"

#include <array>
#include <string>

namespace tumble {
namespace {

constexpr int kShadowUnit = 1;

// A processor that draws has better things to do than what a graphics card does almost for nothing.
struct Quality {
  int edge_samples = 0;
  int shadow_map_size = 1024;
};

Quality quality_for(const Gl& gl) {
  const std::string name = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "SWR"})
    if (name.find(software) != std::string::npos) return {};
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_SAMPLES, &most);
  return {most >= 4 ? 4 : 0, 2048};
}

// A program for a core profile draws nothing without a vertex array, even where it reads none.
struct EmptyArray {
  explicit EmptyArray(const Gl& gl) : gl(gl) { gl.GenVertexArrays(1, &array); }
  ~EmptyArray() { gl.DeleteVertexArrays(1, &array); }
  const Gl& gl;
  GLuint array = 0;
};

class GlRenderer final : public Renderer {
 public:
  explicit GlRenderer(Window& window)
      : window_(window), gl_(load(window)), quality_(quality_for(gl_)), target_(gl_, quality_.edge_samples),
        shadow_map_(gl_, quality_.shadow_map_size),
        mesh_program_(gl_, {"mesh.vert.glsl"}, {"srgb.glsl", "light.glsl", "mesh.frag.glsl"}),
        shadow_program_(gl_, {"mesh.vert.glsl"}, {"shadow.frag.glsl"}),
        sky_program_(gl_, {"sky.vert.glsl"}, {"srgb.glsl", "light.glsl", "sky.frag.glsl"}), meshes_(gl_), textures_(gl_), lines_(gl_), ui_(gl_),
        empty_(gl_) {}
  // Members give their GL objects back after this.
  ~GlRenderer() override { window_.make_current(); }

  void draw(const DrawList& list, int width, int height) override {
    if (width <= 0 || height <= 0) return;
    window_.make_current();
    const double aspect = static_cast<double>(width) / height;
    const WideMatrix camera = camera_matrix(list, aspect);
    const Batches batches = make_batches(list);
    meshes_.upload(batches);
    textures_.begin_picture(list.assets);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    const ShadowFit shadow = draw_shadow_map(list, aspect, batches);
    begin_picture(width, height);
    draw_meshes(list, camera, shadow, batches.opaque);
    draw_sky(list, aspect);
    draw_transparent(list, camera, shadow, batches.transparent);
    lines_.draw(list.lines, camera, width, height);
    ui_.draw(list.ui, textures_, width, height);
    target_.show();
  }

  Picture picture() override {
    window_.make_current();
    return target_.read();
  }

 private:
  static Gl load(Window& window) {
    window.make_current();
    return load_gl(window);
  }

  ShadowFit draw_shadow_map(const DrawList& list, double aspect, const Batches& batches) {
    ShadowFit fit;
    if (list.has_sun && list.sun_shadow) fit = fit_shadow(list, aspect, shadow_map_.size());
    if (!fit.any) return fit;
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_CULL_FACE);
    shadow_map_.begin();
    // Steep faces lie up to a texel deeper at a texel's far edge; the rest is done along the normal (mesh.frag.glsl).
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(1.5f, 2.0f);
    shadow_program_.use();
    shadow_program_.set("matrix", fit.matrix);
    meshes_.draw(batches.opaque);
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    return fit;
  }

  void begin_picture(int width, int height) {
    target_.begin(width, height);
    gl_.DepthMask(GL_TRUE);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);  // the sky covers every pixel
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.Enable(GL_CULL_FACE);
    gl_.Disable(GL_BLEND);
  }

  void set_light(const Program& program, const DrawList& list) const {
    const std::array<float, 4> sun = linear(list.sun_color);
    program.set("sky_top", linear(list.sky_top));
    program.set("sky_horizon", linear(list.sky_horizon));
    program.set("ground_color", linear(list.ground));
    program.set("to_sun", -normalized(list.sun_direction));
    program.set("sun_light", Vec3{sun[0], sun[1], sun[2]} * (list.has_sun ? list.sun_brightness : 0));
  }

  void draw_meshes(const DrawList& list, const WideMatrix& camera, const ShadowFit& shadow,
                   const std::vector<Batch>& batches) {
    if (batches.empty()) return;
    mesh_program_.use();
    set_light(mesh_program_, list);
    mesh_program_.set("matrix", camera);
    mesh_program_.set("shadow_map", kShadowUnit);
    mesh_program_.set("shadow_matrix", shadow.matrix);
    mesh_program_.set("shadow_texel", shadow.texel);
    mesh_program_.set("shadow_pixel", 1.0 / shadow_map_.size());
    mesh_program_.set("shadow_distance", kShadowDistance);
    shadow_map_.bind(kShadowUnit);
    meshes_.draw(batches);
  }

  void draw_sky(const DrawList& list, double aspect) {
    const ViewRays rays = view_rays(list, aspect);
    sky_program_.use();
    set_light(sky_program_, list);
    sky_program_.set("forward", rays.forward);
    sky_program_.set("right", rays.right);
    sky_program_.set("up", rays.up);
    gl_.DepthMask(GL_FALSE);
    gl_.BindVertexArray(empty_.array);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  }

  void draw_transparent(const DrawList& list, const WideMatrix& camera, const ShadowFit& shadow,
                        const std::vector<Batch>& batches) {
    gl_.Enable(GL_BLEND);
    draw_meshes(list, camera, shadow, batches);
    gl_.Disable(GL_BLEND);
  }

  Window& window_;
  const Gl gl_;
  const Quality quality_;
  Target target_;
  ShadowMap shadow_map_;
  Program mesh_program_, shadow_program_, sky_program_;
  GpuMeshes meshes_;
  Textures textures_;
  LinePass lines_;
  UiPass ui_;
  EmptyArray empty_;
};

}  // namespace

std::unique_ptr<Renderer> make_gl_renderer(Window& window) { return std::make_unique<GlRenderer>(window); }

}  // namespace tumble
