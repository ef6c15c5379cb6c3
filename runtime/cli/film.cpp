#include "cli/film.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <utility>

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

bool Film::has_sound(const std::string& file) { return file.ends_with(".mp4"); }

Film::Film(std::string file) : file_(std::move(file)), pictures_(file_) {
  if (!has_sound(file_)) return;
  pictures_ = file_ + ".pictures.mp4";
  sound_ = file_ + ".sound";
}

Film::~Film() {
  if (pipe_) pclose(pipe_);
  if (sound_file_) std::fclose(sound_file_);
  std::error_code ignored;
  if (!sound_.empty()) {
    std::filesystem::remove(sound_, ignored);
    std::filesystem::remove(pictures_, ignored);
  }
}

void Film::open(int width, int height) {
  std::signal(SIGPIPE, SIG_IGN);  // where ffmpeg gives up, finish() says so
  const std::string command = "ffmpeg -y -loglevel error -f rawvideo -pix_fmt rgb24 -s " + std::to_string(width) + "x" + std::to_string(height) +
                              " -r " + std::to_string(kFramesASecond) + " -i - " + (is_gif(file_) ? kGif : kMp4) + " " + shell_word(pictures_);
  pipe_ = popen(command.c_str(), "w");
  if (!pipe_) throw Error("play: --record: ffmpeg could not be started");
}

void Film::take(Runtime& runtime) {
  if (!sound_.empty()) take_sound(runtime);
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

void Film::take_sound(Runtime& runtime) {
  if (!sound_file_) sound_file_ = std::fopen(sound_.c_str(), "wb");
  if (!sound_file_) throw Error("play: --record: '" + sound_ + "' cannot be written");
  const std::vector<float> samples = runtime.take_sound();
  heard_ |= std::any_of(samples.begin(), samples.end(), [](float sample) { return sample != 0; });
  std::fwrite(samples.data(), sizeof(float), samples.size(), sound_file_);
}

// Pictures as they are, with the sound beside them; a silent film has no sound at all.
void Film::join_sound() {
  std::fclose(std::exchange(sound_file_, nullptr));
  if (!heard_) return std::filesystem::rename(pictures_, file_);
  const std::string command = "ffmpeg -y -loglevel error -i " + shell_word(pictures_) + " -f f32le -ar 48000 -ac 2 -i " + shell_word(sound_) +
                              " -c:v copy -c:a aac -b:a 160k -movflags +faststart " + shell_word(file_);
  if (std::system(command.c_str()) != 0) throw Error("play: --record: ffmpeg could not write '" + file_ + "' (see above)");
}

void Film::finish() {
  if (!pipe_) return;
  const int status = pclose(pipe_);
  pipe_ = nullptr;
  if (status != 0) throw Error("play: --record: ffmpeg could not write '" + file_ + "' (see above)");
  if (sound_file_) join_sound();
}

}  // namespace tumble::cli
