#include "assets/library.h"

#include <algorithm>

#include "assets/game_path.h"
#include "assets/gltf.h"
#include "assets/sound.h"
#include "base/text.h"

namespace tumble {

namespace {

bool is_picture(std::string path) {
  for (char& letter : path) letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 'a' - 'A') : letter;
  return path.ends_with(".png") || path.ends_with(".jpg") || path.ends_with(".jpeg") || path.ends_with(".bmp") || path.ends_with(".tga");
}

}  // namespace

AssetLibrary::AssetLibrary(Read read, LogSink log, List list) : read_(std::move(read)), log_(std::move(log)), list_(std::move(list)) {}

void AssetLibrary::warn(const std::string& text) const {
  if (log_) log_({LogLevel::warning, text});
}

template <class T, class Decode>
const T* AssetLibrary::get(std::map<std::string, std::unique_ptr<T>>& kept, const std::string& path, const char* kind, const char* stand_in,
                           Decode decode) {
  const auto [place, fresh] = kept.try_emplace(path);
  if (!fresh) return place->second.get();
  try {
    require_game_path(path);
    const std::optional<std::string> bytes = read_(path);
    if (!bytes) fail("no file '", path, "' in the game", list_ ? did_you_mean(path, list_()) : "");
    require_file_size(path, bytes->size());
    place->second = std::make_unique<T>(decode(*bytes));
  } catch (const std::exception& error) {  // out of memory too, where a file wants more than there is
    warn(std::string(kind) + ": " + error.what() + stand_in);
  }
  return place->second.get();
}

const Image* AssetLibrary::image(const std::string& path) {
  return get(images_, path, "picture", "; it is drawn in pink", [&](const std::string& bytes) { return read_image(bytes, path); });
}

const Model* AssetLibrary::model(const std::string& path) {
  return get(models_, path, "mesh", "; a pink box stands in", [&](const std::string& bytes) { return decode_model(bytes, path); });
}

Model AssetLibrary::decode_model(const std::string& bytes, const std::string& path) {
  if (is_picture(path)) return height_field_of(read_image(bytes, path), path);
  std::vector<std::string>& wanted = wanted_[path];
  wanted.clear();
  Model model = read_model(bytes, path, [&](const std::string& other) {
    wanted.push_back(other);
    return read_(other);
  });
  for (const std::string& note : model.notes) warn("mesh: '" + path + "': " + note);
  return model;
}

std::shared_ptr<const Pcm> AssetLibrary::sound(const std::string& path) {
  using Shared = std::shared_ptr<const Pcm>;
  const Shared* kept = get<Shared>(sounds_, path, "sound", "; there is silence instead", [&](const std::string& bytes) {
    return std::make_shared<const Pcm>(read_sound(bytes, path));
  });
  return kept ? *kept : nullptr;
}

std::uint64_t AssetLibrary::version(const std::string& path) const {
  const auto found = versions_.find(path);
  return found == versions_.end() ? 0 : found->second;
}

std::vector<std::string> AssetLibrary::forget(const std::string& path) {
  std::vector<std::string> old;
  if (images_.contains(path) || models_.contains(path) || sounds_.contains(path)) old.push_back(path);
  for (const auto& [model, files] : wanted_)
    if (model != path && models_.contains(model) && std::find(files.begin(), files.end(), path) != files.end()) old.push_back(model);
  for (const std::string& file : old) {
    images_.erase(file);
    models_.erase(file);
    sounds_.erase(file);
    wanted_.erase(file);
    ++versions_[file];
  }
  return old;
}

}  // namespace tumble
