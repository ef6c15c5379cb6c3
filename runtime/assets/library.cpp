#include "assets/library.h"

#include <algorithm>

#include "assets/sound.h"
#include "base/text.h"

namespace tumble {

AssetLibrary::AssetLibrary(Read read, LogSink log, List list) : read_(std::move(read)), log_(std::move(log)), list_(std::move(list)) {}

template <class T>
const T* AssetLibrary::get(std::map<std::string, std::unique_ptr<T>>& kept, const std::string& path, const char* kind, const char* stand_in,
                           T (*decode)(std::string_view, const std::string&)) {
  const auto [place, fresh] = kept.try_emplace(path);
  if (!fresh) return place->second.get();
  try {
    const std::optional<std::string> bytes = read_(path);
    if (!bytes) fail("no file '", path, "' in the game", list_ ? did_you_mean(path, list_()) : "");
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

std::shared_ptr<const Pcm> AssetLibrary::sound(const std::string& path) {
  using Shared = std::shared_ptr<const Pcm>;
  const Shared* kept = get<Shared>(sounds_, path, "sound", "; there is silence instead", [](std::string_view bytes, const std::string& name) {
    return std::make_shared<const Pcm>(read_sound(bytes, name));
  });
  return kept ? *kept : nullptr;
}

std::uint64_t AssetLibrary::version(const std::string& path) const {
  const auto found = versions_.find(path);
  return found == versions_.end() ? 0 : found->second;
}

void AssetLibrary::forget(const std::string& path) {
  images_.erase(path);
  models_.erase(path);
  sounds_.erase(path);
  ++versions_[path];
}

}  // namespace tumble
