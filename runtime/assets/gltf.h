// Models from glTF 2.0 files: .glb, or .gltf with its .bin and pictures beside it or inside.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "assets/model.h"

namespace tumble {

// Games come from anybody: what would fill the memory is refused.
constexpr std::size_t kMostModelVertices = 4'000'000;    // of all parts together, a shared mesh counted for each node
constexpr std::size_t kMostModelNodes = 100'000;
constexpr std::size_t kMostModelPixels = 64'000'000;     // of all pictures together

// Reads another file of the game that the model names; nothing where there is none.
using ReadOther = std::function<std::optional<std::string>(const std::string& path)>;

// `name` is the file's path in the game: others are looked for beside it. Throws Error where it is no model, is broken,
// or too large.
Model read_model(std::string_view bytes, const std::string& name, const ReadOther& read);

}  // namespace tumble
