// Sprites over the solid things of a picture: from far to near, seen through the air, never before what hides them.
// Small things that glow get a soft halo the same way, since a bright colour alone does not look like a light.
#pragma once

#include <vector>

#include "render/gl/mesh_pass.h"
#include "render/gl/stream.h"

namespace tumble {

class ParticlePass {
 public:
  explicit ParticlePass(const Gl& gl);
  void draw(const PictureState& state, Textures& textures);

 private:
  // As the shader reads it.
  struct Sprite {
    std::array<float, 4> place;  // and half its size
    std::array<float, 4> color;  // linear
    float glow = 0;
    float adds = 0;              // 1 adds its light to what is behind it, 0 hides it
  };

  void collect(const DrawParticles& set, const PictureState& state);
  void collect_halos(const PictureState& state);
  void draw_sprites();

  const Gl& gl_;
  Program program_;
  Stream stream_;
  std::vector<Sprite> sprites_;
};

}  // namespace tumble
