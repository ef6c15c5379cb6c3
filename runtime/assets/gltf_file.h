// A glTF file taken apart: its records, and the bytes that they point into. Nothing in the records is checked yet.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "assets/gltf.h"
#include "base/error.h"

namespace tinygltf {
class Model;
}

namespace tumble {

struct GltfImage {
  std::string uri;     // a path or the picture as text; empty where `view` has its bytes
  int view = -1;
};

struct GltfFile {
  std::string name;                     // in the game, for sentences
  ReadOther read;
  std::shared_ptr<tinygltf::Model> records;
  std::vector<std::string> owned;       // buffers from other files and from text
  std::vector<std::string_view> buffers;
  std::vector<GltfImage> images;
  std::uint64_t fetched = 0;            // bytes of them
};

// `bytes` outlive what is returned. Throws Error.
GltfFile open_gltf(std::string_view bytes, const std::string& name, const ReadOther& read);
// What an uri leads to or holds itself; `what` is what sentences call it.
std::string fetch(GltfFile& file, const std::string& uri, const std::string& what);

// Throws Error in the words that all mistakes of a model file share.
template <class... Parts>
[[noreturn]] void fail_model(const std::string& name, const Parts&... parts) {
  fail("'", name, "' cannot be read as a model: ", parts...);
}

}  // namespace tumble
