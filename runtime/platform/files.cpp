#include "platform/files.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>

#if !defined(_WIN32)
#include <fcntl.h>
#include <unistd.h>
#endif

#include "base/error.h"

namespace fs = std::filesystem;

namespace tumble {

namespace {

// An absolute path from the environment; a relative one would mean another folder in each terminal.
fs::path folder_in(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path path = value ? value : "";
  return path.is_absolute() ? path : fs::path();
}

void check(const std::error_code& error) {
  if (error) fail(error.message());
}

#if defined(_WIN32)

void write_to_disk(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) fail("it cannot be written");
}
void settle_folder(const fs::path&) {}
std::string own_number() { return ""; }

#else

[[noreturn]] void fail_with_errno(int file) {
  const std::string reason = std::strerror(errno);
  if (file >= 0) close(file);
  fail(reason);
}

void write_to_disk(const fs::path& path, const std::string& text) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail_with_errno(file);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) fail_with_errno(file);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  if (fsync(file) != 0) fail_with_errno(file);
  if (close(file) != 0) fail_with_errno(-1);
}

// The new name is on disk once its folder is. Some file systems cannot say so; the text itself is safe by then.
void settle_folder(const fs::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  fsync(file);
  close(file);
}
std::string own_number() { return std::to_string(getpid()); }

#endif

}  // namespace

fs::path data_folder() {
#if defined(_WIN32)
  return folder_in("APPDATA");
#elif defined(__APPLE__)
  const fs::path home = folder_in("HOME");
  return home.empty() ? home : home / "Library" / "Application Support";
#else
  if (const fs::path given = folder_in("XDG_DATA_HOME"); !given.empty()) return given;
  const fs::path home = folder_in("HOME");
  return home.empty() ? home : home / ".local" / "share";
#endif
}

void write_whole_file(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  check(error);
  // With our own number, since two programs may write the same file.
  const fs::path fresh = file.string() + "." + own_number() + ".tmp";
  try {
    write_to_disk(fresh, text);
    fs::rename(fresh, file, error);
    check(error);
  } catch (const Error&) {
    fs::remove(fresh, error);
    throw;
  }
  settle_folder(file.parent_path());
}

}  // namespace tumble
