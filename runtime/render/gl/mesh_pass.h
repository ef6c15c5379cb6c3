// Meshes with their light and textures, and the sun's shadow maps before them. The shader is compiled in the forms that
// a picture needs, since what a form leaves out costs nothing.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "render/air.h"
#include "render/gl/meshes.h"
#include "render/gl/program.h"
#include "render/gl/quality.h"
#include "render/gl/target.h"
#include "render/gl/textures.h"
#include "render/lamps.h"
#include "render/view.h"

namespace tumble {

// What all passes of one picture share.
struct PictureState {
  const DrawList& list;
  double aspect = 1;
  WideMatrix camera;
  Frustum frustum;
  std::vector<Ball> around;       // of the list's meshes
  Air air;
  Lamps lamps;
  std::vector<ShadowFit> shadows; // the nearer first; empty: none
};

// What sky, fog and sun need in every shader that makes colours.
void set_air(const Program& program, const Air& air);

class MeshPass {
 public:
  MeshPass(const Gl& gl, const Quality& quality);

  void begin_picture() { meshes_.begin_picture(); }
  // Fits and draws the maps; writes state.shadows.
  void draw_shadows(PictureState& state, const std::vector<MeshBox>& boxes);
  void upload(const Batches& batches) { meshes_.upload(batches); }
  void draw(const PictureState& state, Textures& textures, const std::vector<Batch>& batches, bool blend);

 private:
  const Program& program_for(const PictureState& state, const Textures::Entry* texture, bool blend);
  void set_picture(const Program& program, const PictureState& state) const;
  ShadowMap& map_for(const PictureState& state);

  const Gl& gl_;
  const Quality quality_;
  Program shadow_program_;
  std::map<int, std::unique_ptr<Program>> programs_;  // by their features
  std::unique_ptr<ShadowMap> shadow_maps_[2];         // for one and for two maps
  GpuMeshes meshes_;
};

}  // namespace tumble
