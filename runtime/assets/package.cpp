#include "assets/package.h"

#include "assets/game_path.h"
#include "assets/package_zip.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace tumble {

namespace {

// ---- folder

class FolderPackage : public Package {
 public:
  FolderPackage(const fs::path& folder, std::string name) : Package(std::move(name)), root_(fs::canonical(folder)) {}
  bool open(const std::string& given_entry) {
    if (!find_entry(given_entry)) return false;
    // Some drives find "MAIN.LUA" for main.lua; a package would not.
    std::string upper = entry().empty() ? "game.json" : entry();
    std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
    folds_case_ = fs::exists(root_ / upper) && !has_exact_name(root_ / upper);
    return find_entry(given_entry);
  }

  bool exists(const std::string& path) const override { return find(path).has_value(); }

  std::optional<std::string> read(const std::string& path) const override {
    const auto file = find(path);
    if (!file) return std::nullopt;
    std::ifstream in(*file, std::ios::binary | std::ios::ate);
    const auto size = in ? static_cast<std::uint64_t>(in.tellg()) : 0;
    require_file_size(path, size);
    std::string bytes(size, '\0');
    if (!in || !in.seekg(0) || !in.read(bytes.data(), static_cast<std::streamsize>(size)))
      fail("file '", path, "': cannot be read; look at its permissions in '", root_.string(), "'");
    return bytes;
  }

  std::vector<std::string> list(const std::string& folder) const override {
    auto files = files_below(root_);
    std::erase_if(files, [](const std::string& path) { return !is_game_path(path); });
    return paths_inside(std::move(files), folder);
  }

  std::optional<fs::path> folder() const override { return root_; }

 private:
  std::optional<fs::path> find(const std::string& path) const {
    require_game_path(path);
    const fs::path file = root_ / path;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return std::nullopt;
    if (folds_case_ && !spelled_exactly(path)) return std::nullopt;

    // A package holds no links, so one may only stand for a file of the same game.
    const fs::path real = fs::canonical(file, error);
    if (error) return std::nullopt;
    if (!real.native().starts_with(root_.native() + '/'))
      fail("file '", path, "': a link that leads out of the game '", name(), "'; copy the file into the game");
    if (fs::canonical(file.parent_path(), error) != file.parent_path())
      fail("file '", path, "': '", fs::path(path).parent_path().string(), "' is a link; copy the folder instead");
    return real;
  }

  bool spelled_exactly(const std::string& path) const {
    fs::path at = root_;
    for (const std::string_view part : parts_of(path))
      if (!has_exact_name(at /= part)) return false;
    return true;
  }

  static bool has_exact_name(const fs::path& path) {
    for (const auto& entry : fs::directory_iterator(path.parent_path()))
      if (entry.path().filename() == path.filename()) return true;
    return false;
  }

  fs::path root_;
  bool folds_case_ = false;
};

// ---- opening

bool looks_like_game(const fs::path& path) {
  std::error_code error;
  return path.extension() == ".tumble" || fs::is_regular_file(path / "main.lua", error) ||
         fs::is_regular_file(path / "game.json", error);
}

std::vector<std::string> names_in(const fs::path& folder, bool games_only) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
    if (!games_only || looks_like_game(entry.path())) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void fail_missing(const fs::path& path) {
  const std::string near = nearest(path.filename().string(), names_in(path.parent_path(), true));
  fail("game '", path.string(), "': there is no such folder or file; ",
       near.empty() ? "give a game's folder, such as one that `tumble new` makes"
                    : "did you mean '" + (path.parent_path() / near).string() + "'?");
}

[[noreturn]] void fail_no_game(const fs::path& path) {
  const std::string near = nearest("main.lua", names_in(path, false));
  auto games = names_in(path, true);
  if (games.size() > 8) games.resize(8), games.push_back("...");
  fail("game '", path.string(), "': neither main.lua nor game.json is in it; ",
       !near.empty()    ? "rename '" + near + "' to 'main.lua'"
       : !games.empty() ? "games are in its folders: " + join(games)
                        : "a game starts with its main.lua");
}

std::string name_of(const fs::path& folder) { return fs::canonical(folder).filename().string(); }

std::unique_ptr<Package> open_existing(const fs::path& path) {
  if (!fs::exists(path)) fail_missing(path);
  if (fs::is_directory(path)) {
    auto package = std::make_unique<FolderPackage>(path, name_of(path));
    if (!package->open("")) fail_no_game(path);
    return package;
  }
  if (path.extension() == ".lua") {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const std::string name = path.filename() == "main.lua" ? name_of(folder) : path.stem().string();
    auto package = std::make_unique<FolderPackage>(folder, name);
    package->open(path.filename().string());
    return package;
  }
  if (auto package = Package::appended_to(path)) return package;
  fail("game '", path.string(), "': ",
       path.extension() == ".tumble" ? "the package is broken (its end is missing); fetch or pack it again"
                                     : "neither a game's folder, a .lua file nor a package");
}

}  // namespace

bool Package::find_entry(const std::string& entry) {
  entry_ = !entry.empty() ? entry : exists("main.lua") ? "main.lua" : "";
  return exists(entry_.empty() ? "game.json" : entry_);
}

std::unique_ptr<Package> Package::open(const fs::path& given) {
  const fs::path path = given.has_filename() ? given : given.parent_path();  // "games/hello/" is "games/hello"
  try {
    return open_existing(path);
  } catch (const fs::filesystem_error& error) {
    fail("game '", path.string(), "': cannot be read (", error.code().message(), "); look at its permissions");
  }
}

std::unique_ptr<Package> Package::appended_to(const fs::path& executable) {
  const auto span = find_zip(executable);
  if (!span) return nullptr;
  auto package = open_zip(executable, *span);
  if (!package)
    fail("game '", executable.string(),
         "': neither main.lua nor game.json is in the package; zip what is in the folder");
  return package;
}

}  // namespace tumble
