#include "assets/library.h"

#include <algorithm>

namespace tumble {

AssetLibrary::AssetLibrary(Read read, LogSink log) : read_(std::move(read)), log_(std::move(log)) {}

template <class T>
const T* AssetLibrary::get(std::map<std::string, std::unique_ptr<T>>& kept, const std::string& path, const char* kind, const char* stand_in,
                           T (*decode)(std::string_view, const std::string&)) {
  const auto [place, fresh] = kept.try_emplace(path);
  if (!fresh) return place->second.get();
  try {
    const std::optional<std::string> bytes = read_(path);
    if (!bytes) fail("no file '", path, "' in the game");
    place->second = std::make_unique<T>(decode(*bytes, path));
  } catch (const Error& error) {
    if (log_) log_({LogLevel::warning, std::string(kind) + ": " + error.what() + stand_in});
  }
  return place->second.get();
}

const Image* AssetLibrary::image(const std::string& path) {
  return get(images_, path, "picture", "; it is drawn in pink", read_image);
}

const Model* AssetLibrary::model(const std::string& path) {
  return get<Model>(models_, path, "mesh", "; a pink box stands in", [](std::string_view, const std::string& name) -> Model {
    fail("'", name, "': models cannot be read yet");
  });
}

std::uint64_t AssetLibrary::version(const std::string& path) const {
  const auto found = versions_.find(path);
  return found == versions_.end() ? 0 : found->second;
}

void AssetLibrary::forget(const std::string& path) {
  images_.erase(path);
  models_.erase(path);
  ++versions_[path];
}

}  // namespace tumble
