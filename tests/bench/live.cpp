// What a person waits for: from the save to the new code, and from the command to the first picture.
#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "bench/bench.h"
#include "support/source_tree.h"
#include "tumble/tumble.h"

namespace fs = std::filesystem;

namespace tumble::bench {

namespace {

constexpr int kSaves = 200, kStarts = 15;

struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "tumble.XXXXXX").string();
    if (!mkdtemp(name.data())) fail("bench: no folder can be made in '", fs::temp_directory_path().string(), "'");
    path = name;
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
};

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The basketball game with some lines more, so that what is reloaded is a whole game: its first tick says which it is.
std::string version_of(const std::string& text, int version) {
  return text + "\nlocal bench_version, bench_told = " + std::to_string(version) +
         ", 0\nfunction late_update() if bench_told ~= bench_version then bench_told = bench_version print('version ' .. bench_version) end end\n";
}

fs::path program() { return fs::read_symlink("/proc/self/exe").parent_path() / "tumble"; }

// Runs the program to its end; how long that took, ms.
double start_once(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const double begin = wall_ms();
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1);
    dup2(nowhere, 2);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  const double end = wall_ms();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("bench: '", words[0], "' failed; build tumble_program beside this program");
  return end - begin;
}

}  // namespace

std::vector<Result> reload() {
  const Folder folder;
  fs::copy(source_tree("games/basketball"), folder.path / "game", fs::copy_options::recursive);
  const fs::path main = folder.path / "game/main.lua", fresh = folder.path / "game/main.lua.new";
  const std::string text = read(main);
  write(main, version_of(text, 0));
  Options options;
  options.offscreen = true;
  options.watch = true;
  options.width = 320;
  options.height = 180;
  Runtime runtime(options);
  std::string told;
  double told_at = 0;
  runtime.on_log([&](LogLevel, const std::string& text) {
    if (!text.starts_with("version ")) return;
    told = text;
    told_at = wall_ms();
  });
  runtime.load((folder.path / "game").string());
  for (int i = 0; i < 60; ++i) runtime.frame();

  // Frames go on at 60 a second, or as fast as pictures can be drawn, while another thread saves at any moment of them.
  std::vector<double> waits, pictures;
  auto next = std::chrono::steady_clock::now();
  for (int i = 1; i <= kSaves; ++i) {
    write(fresh, version_of(text, i));
    double saved = 0;
    std::thread editor([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(i * 7919 % 50000));
      saved = wall_ms();
      fs::rename(fresh, main);
    });
    const double begin = wall_ms();
    while (told != "version " + std::to_string(i) && wall_ms() - begin < 10000 && runtime.frame()) {
      next = std::max(next + std::chrono::microseconds(16667), std::chrono::steady_clock::now());
      std::this_thread::sleep_until(next);
    }
    const double drawn = wall_ms();
    editor.join();
    if (told != "version " + std::to_string(i)) fail("bench: save ", i, " did not reach the game");
    waits.push_back(told_at - saved);
    pictures.push_back(drawn - saved);
  }
  if (runtime.script_errors() > 0) fail("bench: a script failed while it was saved again and again");
  return {{"reload_p99_ms", percentile(waits, 0.99), "ms", "at most 50",
           "rename of main.lua of the basketball game to the first tick in the new code; real-time loop off screen, 200 saves"},
          {"reload_median_ms", median(waits), "ms", "", "the middle one of them"},
          {"reload_picture_p99_ms", percentile(pictures, 0.99), "ms", "", "the same to the end of that tick's frame, its picture drawn"}};
}

std::vector<Result> first_frame() {
  const Folder folder;
  const std::vector<std::string> words = {program().string(), "play", source_tree("games/basketball").string(), "--ticks", "1", "--shot",
                                          (folder.path / "shot.png").string()};
  start_once(words);
  std::vector<double> times;
  for (int i = 0; i < kStarts; ++i) times.push_back(start_once(words));
  return {{"first_frame_ms", median(times), "ms", "at most 300",
           "tumble play games/basketball --ticks 1 --shot FILE from exec to its exit, which comes after the first picture and after writing it; median of 15, warm"}};
}

}  // namespace tumble::bench
