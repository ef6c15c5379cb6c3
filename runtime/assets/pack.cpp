#include "assets/pack.h"

#include "assets/game_path.h"
#include "assets/package.h"
#include "assets/package_zip.h"
#include "base/error.h"

#include <zip.h>

#include <algorithm>
#include <fstream>
#include <list>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace tumble {

namespace {

// An earlier package, also one that is a program.
bool is_package(const fs::path& file) {
  try {
    return Package::appended_to(file) != nullptr;
  } catch (const Error&) {
    return false;  // some other zip
  }
}

bool is_program(const std::string& bytes) {
  return bytes.starts_with("\177ELF") || bytes.starts_with("MZ");
}

void require_writable(const fs::path& output, const std::optional<fs::path>& executable) {
  std::error_code error;
  if (fs::is_directory(output, error))
    fail("pack: the output '", output.string(), "' is a folder; give a file name in it");
  const fs::path parent = output.has_parent_path() ? output.parent_path() : ".";
  if (!fs::is_directory(parent, error))
    fail("pack: there is no folder '", parent.string(), "' for '", output.filename().string(), "'; make it first");
  if (!fs::exists(output, error)) return;
  if (executable && fs::equivalent(output, *executable, error))
    fail("pack: the output '", output.string(), "' is the program itself; give another name");
  if (!is_package(output))
    fail("pack: '", output.string(), "' exists and is no package; give another name or remove it");
}

// Removes a half-written file unless it was renamed in the end.
struct Unfinished {
  fs::path path;
  ~Unfinished() {
    std::error_code error;
    fs::remove(path, error);
  }
};

std::size_t write_zip(const Package& game, const fs::path& folder, const fs::path& output) {
  const auto check = [&](bool done, zip_t* zip, const std::string& what) {
    if (!done) fail("pack: cannot write ", what, " (", zip_strerror(zip), ")");
  };
  int code = 0;
  zip_t* zip = zip_open(output.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  std::unique_ptr<zip_t, void (*)(zip_t*)> guard(zip, zip_discard);
  if (!zip) fail("pack: cannot write '", output.string(), "'; look at the folder's permissions and free space");

  std::list<std::string> contents;  // libzip reads them when it closes the archive
  std::uint64_t total = 0;
  for (const std::string& path : files_below(folder)) {
    auto read = game.read(path);
    if (!read || (is_program(*read) && is_package(folder / path))) continue;
    const std::string& bytes = contents.emplace_back(std::move(*read));
    if (contents.size() > kMaxPackageFiles || (total += bytes.size()) > kMaxPackageBytes)
      fail("pack: '", folder.string(), "' holds more than ", kMaxPackageFiles, " files or ", kMaxPackageBytes >> 20,
           " MB");

    zip_source_t* source = zip_source_buffer(zip, bytes.data(), bytes.size(), 0);
    check(source, zip, path);
    const zip_int64_t index = zip_file_add(zip, path.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) zip_source_free(source);
    check(index >= 0, zip, path);
    // 1 January 1980, the first day that a zip knows, and rw-r--r--: what differs between machines stays out.
    constexpr zip_uint16_t kFirstDay = 1 << 5 | 1;
    constexpr zip_uint32_t kPermissions = 0100644u << 16;
    const auto entry = static_cast<zip_uint64_t>(index);
    check(zip_file_set_dostime(zip, entry, 0, kFirstDay, 0) == 0, zip, path);
    check(zip_file_set_external_attributes(zip, entry, 0, ZIP_OPSYS_UNIX, kPermissions) == 0, zip, path);
  }
  check(zip_close(zip) == 0, zip, "'" + output.string() + "'");
  static_cast<void>(guard.release());  // a successful close frees it
  return contents.size();
}

void copy_bytes(const fs::path& from, std::uint64_t count, std::ofstream& out) {
  std::ifstream in(from, std::ios::binary);
  std::string buffer(1 << 16, '\0');
  while (count > 0) {
    const auto chunk = std::min<std::uint64_t>(count, buffer.size());
    if (!in.read(buffer.data(), static_cast<std::streamsize>(chunk))) break;
    out.write(buffer.data(), static_cast<std::streamsize>(chunk));
    count -= chunk;
  }
  if (count > 0) fail("pack: cannot read '", from.string(), "'; look at its permissions");
}

PackedGame pack(const fs::path& folder, const fs::path& output, const std::optional<fs::path>& executable) {
  const auto game = Package::open(folder);
  if (!game->folder() || !fs::is_directory(folder))
    fail("pack: '", folder.string(), "' is a single file; put it into a folder of its own as main.lua, and pack that");
  if (executable && !fs::is_regular_file(*executable))
    fail("pack: there is no program '", executable->string(), "' to pack the game behind");
  require_writable(output, executable);

  fs::path hidden = output;
  hidden.replace_filename("." + output.filename().string() + ".zip");
  const Unfinished zip{hidden};
  PackedGame packed;
  packed.files = write_zip(*game, *game->folder(), zip.path);

  hidden.replace_extension(".program");
  const Unfinished program{hidden};
  if (executable) {
    const auto span = find_zip(*executable);  // a program that carries a game already gives only itself
    std::ofstream out(program.path, std::ios::binary | std::ios::trunc);
    copy_bytes(*executable, span ? span->start : fs::file_size(*executable), out);
    copy_bytes(zip.path, fs::file_size(zip.path), out);
    if (!out.flush())
      fail("pack: cannot write '", output.string(), "'; look at the folder's permissions and free space");
    out.close();
    fs::permissions(program.path, fs::perms(0755));
  }

  const fs::path& finished = executable ? program.path : zip.path;
  packed.bytes = fs::file_size(finished);
  fs::rename(finished, output);
  return packed;
}

}  // namespace

PackedGame write_package(const fs::path& folder, const fs::path& output, const std::optional<fs::path>& executable) {
  try {
    return pack(folder, output, executable);
  } catch (const fs::filesystem_error& error) {
    fail("pack: cannot write '", output.string(), "' (", error.code().message(), " at '", error.path1().string(), "')");
  }
}

}  // namespace tumble
