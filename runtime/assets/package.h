// One door to the files of a game: a folder, a zip (NAME.tumble), or a zip that lies behind an executable.
//
// A game may come from anybody, and it must read alike from a folder and from a package. So paths are relative,
// separated by '/', case-sensitive everywhere and never lead out of the game; what starts with a dot is no part of it.
// A path that breaks these rules is the author's mistake and throws Error, in every function. One thread at a time.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tumble {

class Package {
 public:
  // A game's folder, a NAME.tumble file, an executable with a game behind it, or one .lua file (its folder is mounted,
  // and it is the entry). Throws Error when there is no game.
  static std::unique_ptr<Package> open(const std::filesystem::path& path);
  // The game behind an executable, or null for a program without one.
  static std::unique_ptr<Package> appended_to(const std::filesystem::path& executable);

  virtual ~Package() = default;
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  virtual bool exists(const std::string& path) const = 0;
  // The file's bytes, or nothing when there is no such file.
  virtual std::optional<std::string> read(const std::string& path) const = 0;
  // All files in a folder of the game and below it, sorted; "" is the whole game.
  virtual std::vector<std::string> list(const std::string& folder = "") const = 0;
  // Where the files can be watched for changes: nothing for an archive.
  virtual std::optional<std::filesystem::path> folder() const { return std::nullopt; }

  // The folder's or the file's name without its ending.
  const std::string& name() const { return name_; }
  // The script to run first, "main.lua" as a rule; "" for a game that has only a game.json.
  const std::string& entry() const { return entry_; }

 protected:
  explicit Package(std::string name) : name_(std::move(name)) {}
  // Takes `entry`, or finds it; false when this is no game.
  bool find_entry(const std::string& entry = "");

 private:
  std::string name_;
  std::string entry_;
};

}  // namespace tumble
