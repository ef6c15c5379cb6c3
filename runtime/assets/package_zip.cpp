#include "assets/package_zip.h"

#include "assets/game_path.h"
#include "base/error.h"

#include <zip.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace tumble {

namespace {

class ZipPackage : public Package {
 public:
  ZipPackage(const fs::path& file, ZipSpan span)
      : Package(file.stem().string()), label_("game '" + file.string() + "': ") {
    if (span.too_large) fail(label_, "refused, since it holds more than ", kMaxPackageFiles, " files or 4 GB");
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_file_create(file.c_str(), span.start, -1, &error);
    zip_.reset(source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr);
    if (!zip_) {
      const std::string why = zip_error_strerror(&error);
      if (source) zip_source_free(source);
      zip_error_fini(&error);
      fail(label_, "the package is broken (", why, "); fetch or pack it again");
    }
    zip_error_fini(&error);
    read_directory();
    step_into_only_folder();
  }
  bool open() { return find_entry(); }

  bool exists(const std::string& path) const override {
    require_game_path(path);
    return files_.contains(path);
  }

  std::optional<std::string> read(const std::string& path) const override {
    require_game_path(path);
    const auto found = files_.find(path);
    if (found == files_.end()) return std::nullopt;

    const auto [index, size] = found->second;
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(zip_.get(), index, 0), zip_fclose);
    if (!file) fail(label_, "'", path, "' cannot be unpacked (", zip_strerror(zip_.get()), "); pack the game again");
    // One byte more than the directory promises: reaching the end makes libzip compare the checksum.
    std::string bytes(size + 1, '\0');
    std::uint64_t filled = 0;
    zip_int64_t n = 0;
    while (filled < bytes.size() && (n = zip_fread(file.get(), bytes.data() + filled, bytes.size() - filled)) > 0)
      filled += static_cast<std::uint64_t>(n);
    if (n < 0 || filled != size)
      fail(label_, "'", path, "' is damaged (", n < 0 ? zip_file_strerror(file.get()) : "its length is wrong",
           "); fetch or pack the game again");
    bytes.resize(size);
    return bytes;
  }

  std::vector<std::string> list(const std::string& folder) const override {
    std::vector<std::string> paths;
    for (const auto& [path, entry] : files_) paths.push_back(path);
    return paths_inside(std::move(paths), folder);
  }

 private:
  struct Entry {
    zip_uint64_t index;
    zip_uint64_t size;
  };

  void read_directory() {
    const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(zip_.get(), 0));
    if (count > kMaxPackageFiles) fail(label_, "refused, since it holds more than ", kMaxPackageFiles, " files");
    zip_uint64_t total = 0;
    for (zip_uint64_t index = 0; index < count; ++index) {
      zip_stat_t stat;
      constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE;
      if (zip_stat_index(zip_.get(), index, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
        fail(label_, "the package is broken (entry ", index, " has no name or size); fetch or pack it again");
      const std::string path = stat.name;
      // What a file manager adds without being asked, such as .DS_Store, is no reason to refuse a game.
      if (path.ends_with('/') || path.starts_with("__MACOSX/")) continue;
      if (!belongs_to_game(path) && path.find("..") == std::string::npos) continue;
      try {
        require_game_path(path);
        require_file_size(path, stat.size);
      } catch (const Error& error) {
        fail(label_, "refused: ", error.what());
      }
      zip_uint8_t system = 0;
      zip_uint32_t attributes = 0;
      zip_file_get_external_attributes(zip_.get(), index, 0, &system, &attributes);
      constexpr zip_uint32_t kFileKind = 0170000, kLink = 0120000;
      if (system == ZIP_OPSYS_UNIX && (attributes >> 16 & kFileKind) == kLink)
        fail(label_, "refused, since '", path, "' is a link; pack the game's folder with `tumble pack`");
      if ((total += stat.size) > kMaxPackageBytes)
        fail(label_, "refused, since it would unpack to more than ", kMaxPackageBytes >> 20, " MB");
      if (!files_.try_emplace(path, Entry{index, stat.size}).second)
        fail(label_, "refused, since it holds '", path, "' twice");
    }
  }

  // File managers zip a folder as "hello/main.lua", where we mean "main.lua".
  void step_into_only_folder() {
    if (files_.empty() || files_.contains("main.lua") || files_.contains("game.json")) return;
    const std::string first = files_.begin()->first;
    const std::string top = first.substr(0, first.find('/') + 1);
    const auto in_top = [&](const auto& file) { return file.first.starts_with(top); };
    if (top.empty() || !std::all_of(files_.begin(), files_.end(), in_top)) return;
    std::map<std::string, Entry> inner;
    for (const auto& [path, entry] : files_) inner.emplace(path.substr(top.size()), entry);
    files_ = std::move(inner);
  }

  std::string label_;
  std::unique_ptr<zip_t, void (*)(zip_t*)> zip_{nullptr, zip_discard};
  std::map<std::string, Entry> files_;
};

}  // namespace

std::unique_ptr<Package> open_zip(const fs::path& file, const ZipSpan& span) {
  auto package = std::make_unique<ZipPackage>(file, span);
  return package->open() ? std::move(package) : nullptr;
}

std::optional<ZipSpan> find_zip(const fs::path& file) {
  constexpr std::size_t kRecord = 22, kMaxComment = 65535;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return std::nullopt;
  const auto size = static_cast<std::uint64_t>(in.tellg());
  const std::size_t length = static_cast<std::size_t>(std::min<std::uint64_t>(size, kRecord + kMaxComment));
  std::string tail(length, '\0');
  in.seekg(static_cast<std::streamoff>(size - length));
  if (length < kRecord || !in.read(tail.data(), static_cast<std::streamsize>(length))) return std::nullopt;

  const auto number = [&](std::size_t at, int bytes) {  // little endian
    std::uint64_t value = 0;
    while (bytes-- > 0) value = value << 8 | static_cast<unsigned char>(tail[at + static_cast<std::size_t>(bytes)]);
    return value;
  };
  // The record ends the file but for its comment. Its directory lies right before it, and says how far from the start.
  for (std::size_t at = length - kRecord + 1; at-- > 0;) {
    if (tail.compare(at, 4, "PK\5\6", 4) != 0 || number(at + 20, 2) != length - at - kRecord) continue;
    const std::uint64_t count = number(at + 10, 2), bytes = number(at + 12, 4), offset = number(at + 16, 4);
    if (count == 0xFFFF || bytes == 0xFFFFFFFF || offset == 0xFFFFFFFF) return ZipSpan{0, true};
    const std::uint64_t record = size - length + at;
    if (bytes + offset <= record) return ZipSpan{record - bytes - offset, false};
  }
  return std::nullopt;
}

}  // namespace tumble
