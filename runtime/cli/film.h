// A film of a game: pictures at a fixed rate, piped to ffmpeg, and for MP4 what is heard with them.
#pragma once

#include <cstdio>
#include <string>

#include "tumble/tumble.h"

namespace tumble::cli {

// Throws Error, beginning with "play: --record", where the ending is neither .gif nor .mp4 or ffmpeg is missing.
void check_film(const std::string& file);

class Film {
 public:
  explicit Film(std::string file);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Can such a film be heard? The runtime then needs a sound track.
  static bool has_sound(const std::string& file);
  // Adds the picture of now where its time has come, and the sound; to be called after every tick.
  void take(Runtime& runtime);
  // Waits for ffmpeg. Throws Error where it failed.
  void finish();

 private:
  void open(int width, int height);
  void take_sound(Runtime& runtime);
  void join_sound();

  std::string file_;
  std::string pictures_, sound_;  // the film while it has no sound yet, and the sound; empty: there is none to be
  std::FILE* sound_file_ = nullptr;
  bool heard_ = false;            // was there anything but silence?
  std::FILE* pipe_ = nullptr;
  int frames_ = 0;
};

}  // namespace tumble::cli
