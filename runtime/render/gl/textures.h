// The game's pictures in the graphics card's memory: sent once, with smaller copies for far things, and again after a
// save.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "render/draw_list.h"
#include "render/gl/functions.h"

namespace tumble {

class Textures {
 public:
  explicit Textures(const Gl& gl);
  ~Textures();
  Textures(const Textures&) = delete;
  Textures& operator=(const Textures&) = delete;

  struct Entry {
    GLuint texture = 0;
    bool has_holes = false;  // some of it is less than opaque
    std::uint64_t version = 0, last_drawn = 0;
  };

  // Before the finds of a picture: forgets what nobody has drawn for a while, and all that came from other assets.
  void begin_picture(AssetLibrary* assets);
  // Samples are linear light times opacity. Pink where there is no such picture.
  const Entry& find(const DrawTexture& texture);
  // For a sampler2D; beyond its edges the picture comes again, or its rim goes on.
  void bind(GLuint texture, int unit, bool again);

 private:
  using Key = std::pair<std::string, int>;

  void upload(Entry& entry, const DrawTexture& texture);
  void forget(const Entry& entry);

  const Gl& gl_;
  AssetLibrary* assets_ = nullptr;
  std::uint64_t picture_ = 0;
  std::map<Key, Entry> entries_;
};

}  // namespace tumble
