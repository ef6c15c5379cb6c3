// Writes a game's folder into one file that Package::open reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace tumble {

struct PackedGame {
  std::size_t files = 0;
  std::uint64_t bytes = 0;  // of the output
};

// Packs the files that belong to the game into `output`: a zip, or with `executable` a copy of that program with the
// zip behind it. The same files give the same bytes on every machine. Hidden files, editors' temporaries and earlier
// packages are left out. Only an earlier package is ever overwritten, and only by a whole one.
PackedGame write_package(const std::filesystem::path& folder, const std::filesystem::path& output,
                         const std::optional<std::filesystem::path>& executable = std::nullopt);

}  // namespace tumble
