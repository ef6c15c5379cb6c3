#include "assets/game_path.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <system_error>

namespace fs = std::filesystem;

namespace tumble {

namespace {

// What is wrong with a path and how to write it, or "".
std::string problem_of(std::string_view path) {
  const std::string text(path);
  if (path.empty()) return "a path must not be empty";
  if (path.find('\0') != std::string_view::npos || !is_utf8(path)) return "a path must be valid UTF-8";
  if (path.find('\\') != std::string_view::npos) {
    std::string slashes = text;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    return "write '/' between folders, not '\\': '" + slashes + "'";
  }
  if (path.starts_with('/') || (path.size() > 1 && path[1] == ':'))
    return "a path starts in the game's folder, not at the disk's root";
  for (const std::string_view part : parts_of(path)) {
    if (part == "..") return "'..' is not allowed; a path starts in the game's folder and stays inside";
    if (part.empty() || part == ".")
      return "leave out '.' and doubled '/': '" + fs::path(path).lexically_normal().generic_string() + "'";
  }
  if (!belongs_to_game(path)) return "hidden files, editors' temporaries and packages are no part of a game; rename it";
  return "";
}

}  // namespace

bool is_game_path(std::string_view path) { return problem_of(path).empty(); }

void require_game_path(std::string_view path) {
  if (const std::string problem = problem_of(path); !problem.empty()) fail("file '", path, "': ", problem);
}

void require_file_size(std::string_view path, std::uint64_t bytes) {
  if (bytes > kMaxFileBytes)
    fail("file '", path, "': too large (", bytes >> 20, " MB); a game's file may have ", kMaxFileBytes >> 20, " MB");
}

std::vector<std::string_view> parts_of(std::string_view path) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0;;) {
    const std::size_t slash = path.find('/', start);
    parts.push_back(path.substr(start, slash - start));
    if (slash == std::string_view::npos) return parts;
    start = slash + 1;
  }
}

bool belongs_to_game(std::string_view path) {
  for (const std::string_view part : parts_of(path))
    if (part.starts_with('.')) return false;
  const std::string_view name = path.substr(path.rfind('/') + 1);
  if (name == "4913") return false;  // Vim tries a folder's permissions with it
  if (name.starts_with('#') && name.ends_with('#')) return false;
  for (const std::string_view suffix : {"~", ".swp", ".swx", ".tmp", ".tumble"})
    if (name.ends_with(suffix)) return false;
  return true;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  const std::size_t skip = (folder / "").generic_string().size();
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; at != fs::recursive_directory_iterator(); at.increment(error)) {
    const std::string path = at->path().generic_string().substr(skip);
    std::error_code vanished;
    if (at->is_directory(vanished)) {
      if (at->path().filename().string().starts_with('.')) at.disable_recursion_pending();
    } else if (at->is_regular_file(vanished) && belongs_to_game(path)) {
      files.push_back(path);
    }
    if (error) break;
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> paths_inside(std::vector<std::string> paths, std::string folder) {
  if (folder.empty()) return paths;
  if (folder.back() == '/') folder.pop_back();
  require_game_path(folder);
  folder += '/';
  std::erase_if(paths, [&](const std::string& path) { return !path.starts_with(folder); });
  return paths;
}

}  // namespace tumble
