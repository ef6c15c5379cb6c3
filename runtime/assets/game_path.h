// Which paths a game's files may have, and which files of a folder belong to the game: the same in a folder, in a
// package, when packing and when watching.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

// A game may come from anybody, so a file that would fill the memory is refused.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{256} << 20;

// Throws Error unless this is a path inside a game, written as it must be: relative, '/' between folders, no '..'.
void require_game_path(std::string_view path);
bool is_game_path(std::string_view path);
// Throws Error for a file larger than kMaxFileBytes.
void require_file_size(std::string_view path, std::uint64_t bytes);

// Is this relative path a file of the game, rather than hidden, an editor's temporary or a package?
bool belongs_to_game(std::string_view path);
// "levels/one.json" -> "levels", "one.json".
std::vector<std::string_view> parts_of(std::string_view path);

// The files below a folder that belong to the game, relative to it, sorted. Links to folders are not followed.
std::vector<std::string> files_below(const std::filesystem::path& folder);
// Of such paths, those in a folder of the game and below it; "" is the whole game.
std::vector<std::string> paths_inside(std::vector<std::string> paths, std::string folder);

}  // namespace tumble
