#include "render/draw_list.h"

#include <algorithm>
#include <iterator>

#include "assets/mesh.h"
#include "base/hash.h"

namespace tumble {

std::uint32_t DrawList::shape_number(const Shape& shape, int part) {
  const std::uint64_t key = part < 0 ? mesh_key(shape) : Hash().add(mesh_key(shape)).add(std::uint64_t(part)).value();
  const auto [place, is_new] = shape_of_key_.try_emplace(key, static_cast<std::uint32_t>(shapes.size()));
  if (is_new) shapes.push_back({shape, part, key});
  return place->second;
}

std::uint32_t DrawList::texture_number(const std::string& file, int image) {
  if (file.empty()) return 0;
  const DrawTexture wanted{file, image};
  const auto number = std::find(textures.begin(), textures.end(), wanted) - textures.begin();
  if (number == std::ssize(textures)) textures.push_back(wanted);
  return static_cast<std::uint32_t>(number);
}

}  // namespace tumble
