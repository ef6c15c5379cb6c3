#include "app/storage_file.h"

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "base/hash.h"
#include "platform/files.h"

namespace fs = std::filesystem;

namespace tumble {

namespace {

// Whatever Storage lets through is far below it, indents and all.
constexpr std::uintmax_t kLargestFile = 16 * Storage::kMostBytes;
constexpr auto kPause = std::chrono::milliseconds(250);  // between two writes

std::string read_text(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) fail("it is no file");
  if (fs::file_size(file, error) > kLargestFile) fail("it is too large");
  std::ifstream in(file, std::ios::binary);
  if (!in) fail("it cannot be read; look at its permissions");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::string storage_name(const std::string& name, const std::string& title, const std::string& author) {
  constexpr std::size_t kLongest = 40;
  std::string plain;
  for (const char c : name.substr(0, kLongest)) plain += std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 128 ? c : '_';
  char number[16];
  const auto mixed = static_cast<std::uint32_t>(Hash().add(name).add(title).add(author).value());
  std::snprintf(number, sizeof number, "%08x", static_cast<unsigned>(mixed));
  return plain + "-" + number;
}

Stored StorageFile::read() {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file_, error))) return {};
  try {
    return read_stored(read_text(file_), file_.filename().string());
  } catch (const Error& failure) {
    set_aside(failure.what());
    return {};
  }
}

void StorageFile::set_aside(const std::string& why) {
  const fs::path aside = file_.string() + ".broken";
  std::error_code error;
  fs::rename(file_, aside, error);
  usable_ = !error;
  log_({LogLevel::warning, "storage: '" + file_.string() + "' is not used (" + why + "); " +
                               (usable_ ? "it is kept as '" + aside.filename().string() + "', and the game begins with nothing stored"
                                        : "it cannot be moved aside, so nothing is stored in this run")});
}

void StorageFile::keep(Storage& storage, bool last) {
  waiting_ |= storage.take_changed();
  if (!waiting_ || !usable_) return;
  if (!last && Clock::now() - written_ < kPause) return;
  written_ = Clock::now();
  try {
    write_whole_file(file_, write_stored(storage.now()));
    waiting_ = told_ = false;
  } catch (const Error& failure) {
    if (!last && !told_) log_({LogLevel::warning, "storage: '" + file_.string() + "' cannot be written (" + failure.what() + "); what the game stores is lost when it ends"});
    told_ = true;
  }
}

}  // namespace tumble
