#include "assets/watch.h"

#include "assets/game_path.h"
#include "base/error.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

#ifdef __linux__
#include <sys/inotify.h>
#include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace tumble {

namespace {

constexpr std::chrono::milliseconds kSweepEvery{250};

std::string below(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + '/' + name;
}

bool is_below(const std::string& path, const std::string& folder) {
  return folder.empty() || path == folder || path.starts_with(folder + '/');
}

}  // namespace

Watch::Watch(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) fail("watch: there is no folder '", folder.string(), "' to watch");
  root_ = fs::canonical(folder);
  start();
  sweep("");
  settle();
}

Watch::~Watch() { stop(); }

std::vector<std::string> Watch::poll() {
  if (inotify_ >= 0) read_events();
  if (inotify_ >= 0 && lost_) {
    stop();
    start();
    sweep("");
  }
  if (inotify_ < 0 && std::chrono::steady_clock::now() >= next_sweep_) {
    sweep("");
    next_sweep_ = std::chrono::steady_clock::now() + kSweepEvery;
  }
  return settle();
}

// Notes every file below a folder that differs from what was last seen.
void Watch::sweep(const std::string& folder) {
  std::set<std::string> present;
  for (const std::string& file : files_below(root_ / folder)) {
    const std::string path = below(folder, file);
    std::error_code error;
    const Seen now{fs::last_write_time(root_ / path, error), fs::file_size(root_ / path, error)};
    const auto before = files_.find(path);
    if (before == files_.end() || before->second != now) changed_.insert(path);
    present.insert(path);
  }
  for (const auto& [path, seen] : files_)
    if (is_below(path, folder) && !present.contains(path)) changed_.insert(path);
}

// Hands out what was noted. A file that was not there before and is not there now was an editor's temporary.
std::vector<std::string> Watch::settle() {
  std::vector<std::string> changed;
  for (const std::string& path : changed_) {
    std::error_code error;
    const Seen now{fs::last_write_time(root_ / path, error), fs::file_size(root_ / path, error)};
    const bool exists = !error;
    if (files_.erase(path) == 0 && !exists) continue;
    if (exists) files_.emplace(path, now);
    changed.push_back(path);
  }
  changed_.clear();
  return changed;
}

void Watch::fall_back(const std::string& reason) {
  stop();
  warning_ = "watch: looking for changed files 4 times a second instead of at once, since " + reason;
  next_sweep_ = {};
}

#ifdef __linux__

void Watch::start() {
  lost_ = false;
  inotify_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (inotify_ < 0)
    return fall_back(errno == EMFILE
                         ? "too many programs or files are open; close some, or raise fs.inotify.max_user_instances"
                         : std::strerror(errno));
  watch_folder("");
}

void Watch::stop() {
  if (inotify_ >= 0) close(inotify_);  // drops its watches and what was queued, too
  inotify_ = -1;
  folders_.clear();
}

void Watch::watch_folder(const std::string& folder) {
  constexpr unsigned kEvents = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO | IN_MOVE_SELF;
  const unsigned how = IN_ONLYDIR | (folder.empty() ? 0u : IN_DONT_FOLLOW);
  const int number = inotify_add_watch(inotify_, (root_ / folder).c_str(), kEvents | how);
  if (number < 0) {
    if (errno == ENOSPC) return fall_back("no more folders can be watched; raise fs.inotify.max_user_watches");
    lost_ |= folder.empty();  // any other folder that vanished meanwhile will be reported by its parent
    return;
  }
  folders_[number] = folder;

  std::error_code error;
  for (fs::directory_iterator at(root_ / folder, error), end; !error && at != end && inotify_ >= 0;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    std::error_code vanished;
    if (!name.starts_with('.') && at->is_directory(vanished) && !at->is_symlink(vanished))
      watch_folder(below(folder, name));
  }
}

void Watch::forget_folder(const std::string& folder) {
  for (auto at = folders_.begin(); at != folders_.end();) {
    if (!is_below(at->second, folder)) {
      ++at;
      continue;
    }
    inotify_rm_watch(inotify_, at->first);
    at = folders_.erase(at);
  }
}

void Watch::read_events() {
  alignas(inotify_event) char buffer[16384];
  while (inotify_ >= 0) {
    const ssize_t length = read(inotify_, buffer, sizeof buffer);
    if (length <= 0) return;
    for (ssize_t at = 0; at < length && inotify_ >= 0;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
      handle(event->wd, event->mask, event->len > 0 ? event->name : "");
      at += static_cast<ssize_t>(sizeof *event + event->len);
    }
  }
}

void Watch::handle(int number, unsigned mask, const std::string& name) {
  if (mask & IN_Q_OVERFLOW) lost_ = true;
  const auto found = folders_.find(number);
  if (found == folders_.end()) return;
  const std::string path = below(found->second, name);

  if (mask & (IN_IGNORED | IN_MOVE_SELF)) {
    if (found->second.empty()) lost_ = true;
    if (mask & IN_IGNORED) folders_.erase(found);
  } else if (mask & IN_ISDIR) {
    if (name.starts_with('.')) return;
    // Watched before it is looked at, so that no file is missed that is written in between.
    if (mask & (IN_DELETE | IN_MOVED_FROM)) forget_folder(path);
    if (mask & (IN_CREATE | IN_MOVED_TO)) watch_folder(path);
    sweep(path);
  } else if (belongs_to_game(path)) {
    // A new file is reported when it is closed; only a link is complete at once.
    std::error_code error;
    if ((mask & IN_CREATE) && !fs::is_symlink(root_ / path, error) && fs::hard_link_count(root_ / path, error) < 2)
      return;
    changed_.insert(path);
  }
}

#else

void Watch::start() { fall_back("this system offers no other way"); }
void Watch::stop() {}

#endif

}  // namespace tumble
