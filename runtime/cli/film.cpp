#include "cli/film.h"

#include <csignal>
#include <cstdlib>

#include "cli/program.h"

namespace tumble::cli {

namespace {

constexpr int kFramesASecond = 30;

bool is_gif(const std::string& file) { return file.ends_with(".gif"); }

// A gif has 256 colours: they are chosen from the whole film, by what moves.
const char* const kGif = "-vf 'split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4' -loop 0";
// Players want even sizes and this pixel format.
const char* const kMp4 = "-vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2' -c:v libx264 -preset medium -crf 20 -pix_fmt yuv420p -movflags +faststart";

}  // namespace

void check_film(const std::string& file) {
  if (!is_gif(file) && !file.ends_with(".mp4")) throw Error("play: --record: a file that ends in .gif or .mp4 expected, got '" + file + "'");
  if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
    throw Error("play: --record needs the program ffmpeg, which is not here; install it (apt-get install ffmpeg), or use --shot for a picture");
}

Film::~Film() {
  if (pipe_) pclose(pipe_);
}

void Film::open(int width, int height) {
  std::signal(SIGPIPE, SIG_IGN);  // where ffmpeg gives up, finish() says so
  const std::string command = "ffmpeg -y -loglevel error -f rawvideo -pix_fmt rgb24 -s " + std::to_string(width) + "x" + std::to_string(height) +
                              " -r " + std::to_string(kFramesASecond) + " -i - " + (is_gif(file_) ? kGif : kMp4) + " " + shell_word(file_);
  pipe_ = popen(command.c_str(), "w");
  if (!pipe_) throw Error("play: --record: ffmpeg could not be started");
}

void Film::take(Runtime& runtime) {
  const double played = static_cast<double>(runtime.tick_number()) * runtime.tick_seconds();
  while (frames_ < played * kFramesASecond) {
    runtime.draw();
    int width = 0, height = 0;
    const std::vector<std::uint8_t> pixels = runtime.picture(width, height);
    if (!pipe_) open(width, height);
    std::fwrite(pixels.data(), 1, pixels.size(), pipe_);
    ++frames_;
  }
}

void Film::finish() {
  if (!pipe_) return;
  const int status = pclose(pipe_);
  pipe_ = nullptr;
  if (status != 0) throw Error("play: --record: ffmpeg could not write '" + file_ + "' (see above)");
}

}  // namespace tumble::cli
