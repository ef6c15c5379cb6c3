#include "platform/window.h"
#include "render/gl/functions.h"
#include "render/gl/line_pass.h"
#include "render/gl/mesh_pass.h"
#include "render/gl/particle_pass.h"
#include "render/gl/quality.h"
#include "render/gl/target.h"
#include "render/gl/textures.h"
#include "render/gl/ui_pass.h"

#include <cmath>

namespace tumble {
namespace {

// What is round may lie by this much within its true outline, pixels.
constexpr double kFlatter = 0.25;

// A program for a core profile draws nothing without a vertex array, even where it reads none.
struct EmptyArray {
  explicit EmptyArray(const Gl& gl) : gl(gl) { gl.GenVertexArrays(1, &array); }
  ~EmptyArray() { gl.DeleteVertexArrays(1, &array); }
  const Gl& gl;
  GLuint array = 0;
};

class GlRenderer final : public Renderer {
 public:
  GlRenderer(Window& window, DrawQuality quality)
      : window_(window), gl_(load(window)), quality_(quality_for(gl_, quality)), target_(gl_, quality_.edge_samples),
        sky_program_(gl_, {"sky.vert.glsl"}, {"srgb.glsl", "air.glsl", "sky.frag.glsl"}), textures_(gl_),
        meshes_(gl_, quality_), particles_(gl_), lines_(gl_), ui_(gl_), empty_(gl_) {}
  // Members give their GL objects back after this.
  ~GlRenderer() override { window_.make_current(); }

  void draw(const DrawList& list, int width, int height) override {
    if (width <= 0 || height <= 0) return;
    window_.make_current();
    textures_.begin_picture(list.assets);
    meshes_.begin_picture();
    PictureState state = look(list, static_cast<double>(width) / height);
    meshes_.draw_shadows(state, boxes_.find(list));

    const double pixel = 2 * std::tan(list.field_of_view / 2) / height;  // rad, in the picture's middle; less elsewhere
    const Batches batches = make_batches(list, state.around, kFlatter * pixel, [&](const Ball& ball) { return state.frustum.may_see(ball); });
    meshes_.upload(batches);
    begin_picture(width, height);
    meshes_.draw(state, textures_, batches.opaque, false);
    draw_sky(state);
    begin_blending();
    meshes_.draw(state, textures_, batches.transparent, true);
    particles_.draw(state, textures_);
    begin_blending();
    lines_.draw(list.lines, state.camera, width, height);
    ui_.draw(list.ui, textures_, width, height);
    target_.show();
  }

  void finish() override {
    window_.make_current();
    gl_.Finish();
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

  PictureState look(const DrawList& list, double aspect) {
    PictureState state{list, aspect, camera_matrix(list, aspect), Frustum(list, aspect), balls(list, boxes_.find(list)),
                       air_of(list), {}, {}};
    state.lamps = choose_lamps(list, state.frustum, static_cast<std::size_t>(quality_.lamps));
    return state;
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

  // After the solid things: only what lies behind none of them gets it.
  void draw_sky(const PictureState& state) {
    const ViewRays rays = view_rays(state.list, state.aspect);
    sky_program_.use();
    set_air(sky_program_, state.air);
    sky_program_.set("fog_height", state.air.fog_height);
    sky_program_.set("forward", rays.forward);
    sky_program_.set("right", rays.right);
    sky_program_.set("up", rays.up);
    gl_.DepthMask(GL_FALSE);
    gl_.BindVertexArray(empty_.array);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  }

  void begin_blending() {
    gl_.Enable(GL_BLEND);
    gl_.Enable(GL_CULL_FACE);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }

  Window& window_;
  const Gl gl_;
  const Quality quality_;
  Target target_;
  Program sky_program_;
  Textures textures_;
  MeshBoxes boxes_;
  MeshPass meshes_;
  ParticlePass particles_;
  LinePass lines_;
  UiPass ui_;
  EmptyArray empty_;
};

}  // namespace

std::unique_ptr<Renderer> make_gl_renderer(Window& window, DrawQuality quality) {
  return std::make_unique<GlRenderer>(window, quality);
}

}  // namespace tumble
