// The pictures, models and sounds of one game, decoded once and kept. What is missing or broken is said once, and a stand-in
// takes its place.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
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
  // The names of all files, for "did you mean"; may be empty.
  using List = std::function<std::vector<std::string>()>;
  AssetLibrary(Read read, LogSink log, List list = {});

  // nullptr where the file is missing or cannot be read: draw a stand-in. Stays valid until forget(). A picture asked
  // for as a model is a height field 1 m wide, high and deep.
  const Image* image(const std::string& path);
  const Model* model(const std::string& path);
  // Kept by who plays it, also over forget(); null: stay silent.
  std::shared_ptr<const Pcm> sound(const std::string& path);
  // Another number after each forget(): what a renderer made from the file is old then.
  std::uint64_t version(const std::string& path) const;
  // The file was saved, or is gone. Returns the files that are to be read again: it, and models that take bytes or
  // pictures from it; none where nobody asked for them.
  std::vector<std::string> forget(const std::string& path);

 private:
  template <class T, class Decode>
  const T* get(std::map<std::string, std::unique_ptr<T>>& kept, const std::string& path, const char* kind, const char* stand_in, Decode decode);
  Model decode_model(const std::string& bytes, const std::string& path);
  void warn(const std::string& text) const;

  Read read_;
  LogSink log_;
  List list_;
  std::map<std::string, std::unique_ptr<Image>> images_;   // null: tried in vain
  std::map<std::string, std::unique_ptr<Model>> models_;
  std::map<std::string, std::unique_ptr<std::shared_ptr<const Pcm>>> sounds_;
  std::map<std::string, std::vector<std::string>> wanted_;  // by a model: files beside it, found or not
  std::map<std::string, std::uint64_t> versions_;
};

}  // namespace tumble
