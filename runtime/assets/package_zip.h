// A game inside a zip, which may begin anywhere in its file: a NAME.tumble, or behind an executable.
#pragma once

#include "assets/package.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace tumble {

// What a package may hold at most, so that a hostile one is refused. The number of files is the most that a zip can
// count without its 64-bit extension.
constexpr std::uint64_t kMaxPackageBytes = std::uint64_t{2} << 30;
constexpr std::size_t kMaxPackageFiles = 65534;

// A zip inside a file: from `start` to the file's end.
struct ZipSpan {
  std::uint64_t start = 0;
  bool too_large = false;  // needs the 64-bit extension, which no game does
};

// Looks for the end record of a zip at the end of the file.
std::optional<ZipSpan> find_zip(const std::filesystem::path& file);
// Null when the zip holds no game; throws Error when it is broken or breaks the rules of a package.
std::unique_ptr<Package> open_zip(const std::filesystem::path& file, const ZipSpan& span);

}  // namespace tumble
