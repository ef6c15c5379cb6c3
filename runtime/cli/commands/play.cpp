// play: in a window, off screen, or without drawing at all.
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/commands/commands.h"
#include "cli/film.h"
#include "cli/program.h"

namespace fs = std::filesystem;

namespace tumble::cli {

namespace {

struct Play {
  std::string game;
  bool headless = false, bot = false, gles = false, fullscreen = false, no_watch = false, mute = false;
  std::int64_t ticks = 0;  // 0: not given
  std::uint64_t seed = 1;
  std::string shot, record, replay, save_replay, report, size;
};

constexpr double kLongestSeconds = 600;  // of game time, for a run that should come to its end by itself
constexpr double kShowSeconds = 20;      // of game time, for showing a game where there is no display

void read_size(const std::string& text, Options& options) {
  int used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &options.width, &options.height, &used) != 2 || used != static_cast<int>(text.size()) ||
      options.width < 16 || options.height < 16 || options.width > 16384 || options.height > 16384)
    throw Error("play: --size: WIDTHxHEIGHT in pixels expected, 16x16 to 16384x16384, got '" + text + "'; write --size 1280x720");
}

Options options_of(const Play& play) {
  Options options;
  options.bot = play.bot;
  options.seed = play.seed;
  options.storage = storage_folder();
  options.gles = play.gles;
  options.fullscreen = play.fullscreen;
  if (!play.size.empty()) {
    read_size(play.size, options);
  } else if (play.record.ends_with(".gif")) {
    options.width = 640;
    options.height = 360;
  }
  return options;
}

// Only a runtime can look into every kind of package.
bool has_bot(const Play& play) {
  Runtime runtime;
  runtime.load(play.game);
  return runtime.has_file("bot.lua");
}

void load(Runtime& runtime, const Play& play) {
  show_messages(runtime);
  if (!play.replay.empty()) runtime.play_recording(play.replay);
  runtime.load(play.game);
  if (play.bot && runtime.is_loaded() && !runtime.has_file("bot.lua")) throw Error("play: --bot: this game has no bot.lua; leave out --bot, or write one (./tumble new shows one)");
}

std::string report_text(const Runtime& runtime) {
  char numbers[256];
  std::snprintf(numbers, sizeof numbers,
                "\"ticks\": %" PRId64 ", \"frames\": %" PRId64 ", \"script_errors\": %d, \"hash\": \"%016" PRIx64 "\", \"seconds\": %.6f, \"dropped_seconds\": %.6f",
                runtime.tick_number(), runtime.frame_number(), runtime.script_errors(), runtime.hash(), runtime.seconds(), runtime.dropped_seconds());
  std::string game = runtime.report_json();
  while (game.ends_with('\n')) game.pop_back();
  return std::string("{") + numbers + ", \"game\": " + game + "}\n";
}

// The files that were asked for, and the exit status: a script's failure counts where nobody was there to see it.
int finish(Runtime& runtime, const Play& play, bool watched) {
  if (!play.save_replay.empty()) runtime.save_recording(play.save_replay);
  if (!play.report.empty()) write_file(play.report, report_text(runtime), "play: --report");
  std::cout.flush();
  return runtime.is_loaded() && (watched || runtime.script_errors() == 0) ? 0 : 1;
}

int play_window(const Play& play) {
  Options options = options_of(play);
  options.window = true;
  options.watch = !play.no_watch;
  options.sound = !play.mute;
  Runtime runtime(options);
  load(runtime, play);
  while (runtime.frame()) {}
  return finish(runtime, play, true);
}

// Ticks without a window until the ticks or seconds are over or the game ends.
void run(Runtime& runtime, const Play& play, double most_seconds, Film* film) {
  const auto most = play.ticks ? play.ticks : static_cast<std::int64_t>(most_seconds / runtime.tick_seconds() + 0.5);
  const bool to_replay_end = !play.replay.empty() && !play.ticks;
  for (std::int64_t i = 0; i < most && !runtime.is_finished() && !runtime.wants_quit() && runtime.is_loaded(); ++i) {
    if (to_replay_end && !runtime.is_replaying()) break;
    runtime.tick();
    if (film) film->take(runtime);
  }
}

int play_headless(const Play& play) {
  if (!play.shot.empty() || !play.record.empty())
    throw Error("play: --headless draws nothing, so there is no picture for --shot or --record; leave out --headless");
  if (!play.ticks && !play.bot && play.replay.empty())
    throw Error("play: --headless: nobody plays, so it would never end; add --ticks N, or --bot to let the game's bot play");
  Runtime runtime(options_of(play));
  load(runtime, play);
  run(runtime, play, kLongestSeconds, nullptr);
  if (!play.ticks && play.replay.empty() && !runtime.is_finished() && !runtime.wants_quit() && runtime.is_loaded())
    std::cerr << "play: not finished after " << kLongestSeconds / 60 << " minutes of game time; stopped\n";
  return finish(runtime, play, false);
}

// Off screen to the end that was asked for; pictures only where one is wanted.
int play_offscreen(const Play& play) {
  Options options = options_of(play);
  options.offscreen = true;
  options.sound_track = !play.mute && Film::has_sound(play.record);
  Runtime runtime(options);
  load(runtime, play);
  std::optional<Film> film;
  if (!play.record.empty()) film.emplace(play.record);
  run(runtime, play, options.bot ? kLongestSeconds : kShowSeconds, film ? &*film : nullptr);
  if (film) film->finish();
  if (!play.shot.empty()) {
    runtime.draw();
    runtime.save_picture(play.shot);
  }
  return finish(runtime, play, false);
}

// Nobody can see a window here: shows the game by a picture, and says so.
int play_for_a_picture(Play play) {
  const bool bot = play.bot || (play.replay.empty() && has_bot(play));
  play.bot = bot;
  play.shot = game_name(play.game) + ".png";
  Options options = options_of(play);
  options.offscreen = true;
  Runtime runtime(options);
  load(runtime, play);
  run(runtime, play, kShowSeconds, nullptr);
  runtime.draw();
  runtime.save_picture(play.shot);
  const int status = finish(runtime, play, false);
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3g", static_cast<double>(runtime.tick_number()) * runtime.tick_seconds());
  std::cout << "No display here, so " << (bot ? "the game's bot played " : "the game ran by itself for ") << seconds << " s off screen"
            << (runtime.is_finished() ? ", to its end" : "") << "; the picture is '" << play.shot << "'." << std::endl;
  return status;
}

int play_game(const Play& play) {
  if (!play.shot.empty() && !play.shot.ends_with(".png")) throw Error("play: --shot: a file that ends in .png expected, got '" + play.shot + "'");
  if (!play.record.empty()) check_film(play.record);
  if (play.headless) return play_headless(play);
  if (play.ticks || !play.shot.empty() || !play.record.empty()) return play_offscreen(play);
  return display_available() ? play_window(play) : play_for_a_picture(play);
}

void add_options(CLI::App& verb, Play& play) {
  verb.add_flag("--headless", play.headless, "Draw nothing; needs --ticks or --bot");
  verb.add_flag("--bot", play.bot, "Let the game's bot.lua play");
  verb.add_option("--ticks", play.ticks, "End after so many ticks, or when the game is finished; draws off screen")->check(CLI::PositiveNumber);
  verb.add_option("--seed", play.seed, "Seed of the game's random numbers (1)");
  verb.add_option("--shot", play.shot, "Write a picture of the last tick; draws off screen")->type_name("FILE.png");
  verb.add_option("--record", play.record, "Write a film of 30 pictures a second; draws off screen")->type_name("FILE.gif|mp4");
  verb.add_option("--replay", play.replay, "Play what --save-replay wrote")->type_name("FILE");
  verb.add_option("--save-replay", play.save_replay, "Write the input for --replay")->type_name("FILE");
  verb.add_option("--report", play.report, "Write ticks, errors, the world's hash and game.report")->type_name("FILE.json");
  verb.add_flag("--gles", play.gles, "Draw with OpenGL ES 3.0");
  verb.add_option("--size", play.size, "Size of the window or picture in pixels")->type_name("WxH");
  verb.add_flag("--fullscreen", play.fullscreen, "Start in full screen");
  verb.add_flag("--mute", play.mute, "Play without sound");
  verb.add_flag("--no-watch", play.no_watch, "Do not take over saved files");
}

}  // namespace

void add_play(CLI::App& app, int& status) {
  auto play = std::make_shared<Play>();
  CLI::App* verb = app.add_subcommand("play", "Play a game: a folder, a .tumble file or one .lua file");
  verb->add_option("game", play->game, "The game")->required()->type_name("GAME");
  add_options(*verb, *play);
  verb->callback([play, &status] { status = play_game(*play); });
}

void add_packed_play(CLI::App& app, const std::string& program, int& status) {
  auto play = std::make_shared<Play>();
  play->game = program;
  app.description("A game made with Tumble.");
  app.name(fs::path(program).filename().string());
  add_options(app, *play);
  app.callback([play, &status] { status = play_game(*play); });
}

}  // namespace tumble::cli
