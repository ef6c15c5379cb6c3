// A film of a game: pictures at a fixed rate, piped to ffmpeg.
#pragma once

#include <cstdio>
#include <string>

#include "tumble/tumble.h"

namespace tumble::cli {

// Throws Error, beginning with "play: --record", where the ending is neither .gif nor .mp4 or ffmpeg is missing.
void check_film(const std::string& file);

class Film {
 public:
  explicit Film(std::string file) : file_(std::move(file)) {}
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Adds the picture of now where its time has come; to be called after every tick.
  void take(Runtime& runtime);
  // Waits for ffmpeg. Throws Error where it failed.
  void finish();

 private:
  void open(int width, int height);

  std::string file_;
  std::FILE* pipe_ = nullptr;
  int frames_ = 0;
};

}  // namespace tumble::cli
