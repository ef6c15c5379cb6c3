// The pictures, models and sounds of one game, decoded once and kept. What is missing or broken is said once, and a stand-in
// takes its place.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/image.h"
#include "assets/model.h"
#include "base/log.h"
#include "base/pcm.h"

namespace tumble {

class AssetLibrary {
 public:
  // Reads a file of the game; nothing where there is none.
  using Read = std::function<std::optional<std::string>(const std::string& path)>;
  // All files of the game, for the nearest name to a missing one.
  using List = std::function<std::vector<std::string>()>;
  AssetLibrary(Read read, LogSink log, List list = {});

  // nullptr where the file is missing or cannot be read: draw a stand-in. Stays valid until forget().
  const Image* image(const std::string& path);
  const Model* model(const std::string& path);
  // Kept by who plays it, also over forget(); null: stay silent.
  std::shared_ptr<const Pcm> sound(const std::string& path);
  // Another number after each forget(): what a renderer made from the file is old then.
  std::uint64_t version(const std::string& path) const;
  // The file was saved, or is gone.
  void forget(const std::string& path);

 private:
  template <class T>
  const T* get(std::map<std::string, std::unique_ptr<T>>& kept, const std::string& path, const char* kind, const char* stand_in, T (*decode)(std::string_view, const std::string&));

  Read read_;
  LogSink log_;
  List list_;
  std::map<std::string, std::unique_ptr<Image>> images_;   // null: tried in vain
  std::map<std::string, std::unique_ptr<Model>> models_;
  std::map<std::string, std::unique_ptr<std::shared_ptr<const Pcm>>> sounds_;
  std::map<std::string, std::uint64_t> versions_;
};

}  // namespace tumble
