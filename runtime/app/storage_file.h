// The file in which a game's storage lies between two runs.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "base/log.h"
#include "engine/storage.h"

namespace tumble {

// The folder of a game below the one of all games: its name in plain letters, and a number made of name, title and
// author, so that games with like names do not share a storage.
std::string storage_name(const std::string& name, const std::string& title, const std::string& author);

class StorageFile {
 public:
  // `folder`: the game's own; it is made when something is written.
  StorageFile(std::filesystem::path folder, LogSink log) : file_(folder / "storage.json"), log_(std::move(log)) {}

  // What was stored. A file that is broken is moved aside, with a sentence in the log; then nothing was stored.
  Stored read();
  // Soon after the first change, and from then on a few times a second, since a disk may need as long as some pictures
  // do. `last`: what is due now or never; failures are then told to nobody.
  void keep(Storage& storage, bool last);

 private:
  using Clock = std::chrono::steady_clock;
  void set_aside(const std::string& why);

  std::filesystem::path file_;
  LogSink log_;
  bool usable_ = true;      // false where writing would destroy what could not be moved aside
  bool waiting_ = false;    // something is changed and not written
  bool told_ = false;       // of a failure to write
  Clock::time_point written_{};
};

}  // namespace tumble
