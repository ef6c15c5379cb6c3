// Tells which files of a game's folder have changed on disk, for reloading while it runs.
//
// Watches folders, not files: a watch on a file dies at the first editor that saves by renaming. A file is reported
// when it has been closed after writing, never half written. Where the system offers no more watches, and elsewhere
// than on Linux, it compares sizes and times a few times a second instead, and warning() says so.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tumble {

class Watch {
 public:
  // The folder may vanish and come back. Throws Error when it does not exist at the start.
  explicit Watch(const std::filesystem::path& folder);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // The files written, made, renamed or removed since the last call, relative to the folder with '/', sorted, each
  // once. Only files that belong to the game (game_path.h). Does not wait, and costs one system call when nothing
  // happened.
  std::vector<std::string> poll();
  // Why changes are found late, or "".
  const std::string& warning() const { return warning_; }

 private:
  struct Seen {
    std::filesystem::file_time_type time;
    std::uintmax_t bytes;
    bool operator==(const Seen&) const = default;
  };

  void start();
  void stop();
  void fall_back(const std::string& reason);
  void watch_folder(const std::string& folder);
  void forget_folder(const std::string& folder);
  void read_events();
  void handle(int number, unsigned mask, const std::string& name);
  void sweep(const std::string& folder);
  std::vector<std::string> settle();

  std::filesystem::path root_;
  std::map<std::string, Seen> files_;   // as of the last poll
  std::set<std::string> changed_;       // collected for this poll
  std::map<int, std::string> folders_;  // inotify's number of a watched folder -> its path, "" for the root
  int inotify_ = -1;                    // -1: comparing sizes and times instead
  bool lost_ = false;                   // the root is gone, or events were dropped: start again and look at everything
  std::chrono::steady_clock::time_point next_sweep_;
  std::string warning_;
};

}  // namespace tumble
